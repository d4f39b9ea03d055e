namespace ellipsoid {
int   f( );
}
