// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// What the hosts that this package is compiled with call differently: LIGGGHTS-PUBLIC (and
// PICI-LIGGGHTS), or LIGGGHTS-INL. Pair styles: host_pair.h; meshes: host_mesh.h.
#ifndef ELLIPSOID_HOST_VARIANTS_H
#define ELLIPSOID_HOST_VARIANTS_H

#if __has_include("iloopcallbackcaller.h")
#define ELLIPSOID_HOST_INL
#endif

/// The parameters of Fix::restart().
#ifdef ELLIPSOID_HOST_INL
#define ELLIPSOID_RESTART_PARAMETERS char *buffer, const Version &
#else
#define ELLIPSOID_RESTART_PARAMETERS char* buffer
#endif

#endif
