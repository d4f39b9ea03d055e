// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "host_styles.h"

#include <string>

namespace ellipsoid_host {

namespace {

/// Styles of one kind that share a reason and a remedy.
struct UnsuitedStyles {
  const char* kind;
  const char* styles; ///< with a space between two
  const char* reason_and_remedy;
};

constexpr UnsuitedStyles unsuited_styles[] = {
    // --- motion
    {"fix",
     "nve nve/asphere nve/asphere/noforce nve/limit nve/line nve/noforce nve/sph "
     "nve/sph/stationary nve/sphere nve/superquadric nve/nonspherical nve/convexhull "
     "nve/cfd_cn/sphere nve/sphere/limit",
     "does not move ellipsoids by their own equations; use 'fix ID GROUP nve/ellipsoid'"},
    {"fix",
     "rigid multisphere multisphere/nointegration concave multisphere/break multisphere/advanced "
     "concave/advanced",
     "makes bodies of spheres and turns no ellipsoid; use 'fix nve/ellipsoid', with 'subspheres' "
     "in 'fix particletemplate/ellipsoid' for multi-spheres"},
    {"fix", "enforce2d", "is for 2d simulations; use 'fix ID GROUP nve/ellipsoid planar yes'"},
    {"fix", "box/relax", "is for 'minimize', which knows no friction; use 'fix deform'"},
    {"fix", "adapt",
     "changes the bounding sphere and not the semi-axes; use 'set ... shape a b c' between two "
     "runs"},
    {"fix", "set/vel", "is not shown to be right for ellipsoids; use 'fix move'"},
    // --- forces
    {"fix", "dragforce", "takes bounding spheres for the bodies; use 'fix couple/cfd/force'"},
    {"fix", "efield", "acts on charges, which ellipsoids do not have; use 'fix addforce'"},
    {"fix", "external",
     "takes its forces from a program that calls the host, which nobody checks; use 'fix "
     "addforce' with a variable"},
    {"fix", "spring/rg", "needs a mass for each type; use 'fix spring' or 'fix spring/self'"},
    {"fix", "fiber/spring/simple", "joins spheres; remove it"},
    {"fix",
     "couple/cfd/dragforce couple/cfd/convectiveImpl couple/cfd/convection "
     "couple/cfd/radiation couple/cfd/speciesConvection couple/cfd/force/implicit "
     "couple/lb/onetoone",
     "exchanges what a solver computes for spheres; use 'fix couple/cfd/force'"},
    {"fix", "check/timestep/gran check/timestep/sph",
     "knows spheres only; use 'fix ID GROUP check/timestep/ellipsoid'"},
    {"fix", "multicontact/halfspace", "corrects contacts of spheres; remove it"},
    {"fix",
     "sph/density/continuity sph/density/corr sph/density/summation sph/pressure "
     "sph/density/drift/corr sph/integrity sph/mixidx sph/velgrad",
     "is for SPH particles; remove it"},
    {"fix", "deform/check", "looks at histories of spheres; use 'fix ID GROUP deform'"},
    // --- walls
    {"fix", "wall/gran wall/region wall/region/sph wall/sph wall/sph/general wall/sph/general/gap",
     "knows bounding spheres or centres only; use 'fix ID GROUP wall/gran/ellipsoid' with "
     "'surface smooth' or 'surface multisphere'"},
    {"fix", "move/mesh/gran", "is an old name; use 'fix ID GROUP move/mesh'"},
    {"fix", "massflow/mesh/sieve", "lets bounding spheres pass; use 'fix massflow/mesh'"},
    {"fix", "move/mesh/file", "is another name; use 'fix ID GROUP move/mesh'"},
    {"fix", "mesh/surface/liquidtransfer",
     "needs liquid on bounding spheres; use 'fix ID GROUP mesh/surface'"},
    {"fix", "mesh/surface/6dof",
     "moves a mesh by the forces on it, which is not shown to be right; use 'fix move/mesh'"},
    // --- where particles come from
    {"fix", "insert/fragments", "puts fragments of spheres; use 'fix insert/pack'"},
    {"fix", "particletemplate/sphere particletemplate/superquadric",
     "makes no ellipsoids; use 'fix ID GROUP particletemplate/ellipsoid SEED semiaxes a b c "
     "density D', with a = b = c for spheres"},
    {"fix", "particletemplate/multiplespheres particletemplate/multisphere",
     "makes bodies of several particles; use 'fix ID GROUP particletemplate/ellipsoid SEED "
     "semiaxes a b b density D subspheres N', or 'clump FILE' in place of 'semiaxes' and "
     "'subspheres'"},
    // --- made by the host itself
    {"fix",
     "contacthistory contacthistory/mesh contactproperty/atom contactproperty/atom/wall "
     "neighlist/mesh MINIMIZE READ_RESTART RESPA STORE diam/max",
     "is made by the host itself where it is needed; remove the command"},
    {"fix", "custom_property/global property/atomtype property/atomtypepair",
     "is an old name; use 'fix ID all property/global'"},
    {"fix", "property/atom/timetracer property/atom/regiontracer/time property/atom/tracer/stream",
     "is not shown to be right for ellipsoids; use 'fix property/atom/tracer'"},
    {"fix", "region/variable",
     "is not shown to be right for ellipsoids; use one region for each run"},
    {"fix", "ave/euler/stress", "is another name; use 'fix ID GROUP ave/euler'"},
    // --- measures
    {"compute",
     "atom/molecule com/molecule gyration/molecule inertia/molecule msd/molecule "
     "property/molecule bond/local",
     "needs molecules, which ellipsoids do not have; remove it"},
    {"compute", "centro/atom cna/atom",
     "looks for crystals of points; use 'compute coordination/ellipsoid'"},
    {"compute", "contact/atom contact/atom/gran",
     "counts touching bounding spheres; use 'compute ID GROUP coordination/ellipsoid'"},
    {"compute",
     "erotate erotate/asphere erotate/sphere erotate/sphere/atom erotate/superquadric "
     "erotate/multisphere",
     "does not know ellipsoids; use 'compute ID GROUP erotate/ellipsoid'"},
    {"compute", "ke/multisphere rigid multisphere multisphere/single",
     "reads the bodies of 'fix multisphere' or 'fix rigid'; use 'compute property/atom'"},
    {"compute", "group/group property/local pair/gran/local",
     "does not know the contacts of ellipsoids; use 'compute ID GROUP pair/ellipsoid/local'"},
    {"compute", "wall/gran/local",
     "does not know the contacts of ellipsoids; use 'compute ID GROUP wall/ellipsoid/local'"},
    {"compute", "bond/counter pair/gran/local/bond wall/gran/local/bond",
     "looks for bonds, which ellipsoids do not have; remove it"},
    {"compute", "angmom",
     "is not shown to be right for ellipsoids; use 'compute property/atom' with 'angmomx angmomy "
     "angmomz'"},
    {"compute", "SauterDiameter",
     "needs the area of superquadrics; use 'compute property/atom' with 'shapex shapey shapez'"},
    {"compute", "crosssection surface velocity/mesh",
     "is not shown to be right for ellipsoids; remove it"},
    {"compute", "pe pe/atom", "is always 0, since contacts tell the host no energy; remove it"},
    {"compute", "reduce/sph", "is for SPH particles; use 'compute reduce'"},
    {"fix", "continuum/weighted",
     "leaves out particles beyond the lists of contacts, and takes one contact for each pair; use "
     "'compute ID GROUP continuum/weighted/ellipsoid' with the same keywords"},
    // --- pictures
    {"dump", "local/gran/vtk",
     "lists bounding spheres; use 'dump ID GROUP local' with 'compute pair/ellipsoid/local'"},
    {"dump", "image movie",
     "draws bounding spheres; use 'dump custom' and 'ellipsoid-post render3d'"},
    {"dump", "atom/vtk", "writes bounding spheres; use 'dump custom/vtk'"},
    {"dump", "stl", "is an old name; use 'dump ID GROUP mesh/stl'"},
    {"dump", "custom/vtm euler/vtk mesh/gran/VTK mesh/vtm",
     "is not shown to be right for ellipsoids; use 'dump custom/vtk' or 'dump mesh/vtk'"},
    // --- pair styles
    {"pair_style",
     "gran bubble gran_bubble line/lj soft sph/artVisc/tensCorr "
     "sph/morris/tensCorr hybrid hybrid/overlay none",
     "knows no ellipsoids; use 'pair_style gran/ellipsoid' with 'surface smooth' or 'surface "
     "multisphere' after the other models, and no 'hybrid'"},
    // --- commands
    {"fix", "balance",
     "is not shown to be right for ellipsoids; use 'fix ID GROUP balance/ellipsoid'"},
    {"command", "comm_style",
     "is not shown to be right for ellipsoids; use 'balance/ellipsoid' for even loads"},
    {"command", "balance", "is not shown to be right for ellipsoids; use 'balance/ellipsoid'"},
    {"command", "coarsegraining", "scales spheres; give the semi-axes that are wanted"},
    {"command", "create_particles",
     "is not shown to be right for ellipsoids; use 'create_atoms' or 'fix insert/pack'"},
    {"command", "rerun", "knows neither semi-axes nor moments; use 'ellipsoid-post'"},
    {"command", "set/multisphere", "changes the bodies of 'fix multisphere'; use 'set'"},
    {"run_style", "respa", "splits the forces of contacts; use 'run_style verlet'"},
    {"command", "read_dump",
     "knows neither semi-axes nor moments; use 'read_data' or 'read_restart'"},
    {"region", "wedge",
     "has a bounding box that cuts off parts of it; use 'region ID intersect 3' of a cylinder and "
     "two planes"},
    {"region", "mesh/tet",
     "knows no distance from its surface; use 'union' and 'intersect' of other kinds"},
    {"command", "minimize", "knows no friction and turns no body; use 'run' with damping"},
    {"command", "rotate",
     "does nothing in this host; use 'displace_atoms GROUP rotate' or 'fix move rotate'"},
    {"command", "replicate",
     "copies spheres only; use 'fix insert/pack', or write the particles to a data file"},
    {"command",
     "delete_bonds angle_style bond_style dihedral_style improper_style kspace_style angle_coeff "
     "bond_coeff dihedral_coeff improper_coeff kspace_modify special_bonds dielectric",
     "needs bonds or charges, which ellipsoids do not have; remove it"},
    {"command", "min_style min_modify", "is for 'minimize', which knows no friction; remove it"},
    {"command", "pair_modify pair_write",
     "is for potentials, and contact laws have none; remove it"},
    {"command", "suffix package", "chooses accelerated styles, which this host lacks; remove it"},
    {"command", "mass",
     "gives masses to types; use 'density' or 'mass' of the template, or 'set ... density'"},
    // --- of LIGGGHTS-PFM alone
    {"fix",
     "GROUP SHEAR_HISTORY ave/euler/region ave/euler/region/universe bond/create/gran "
     "bond/propagate/gran break/particle chem/shrink chem/shrink/Arrhenius chem/shrink/core "
     "chem/shrink/core/single couple/cfd/chemistry couple/cfd/deform couple/cfd/dissolve "
     "couple/cfd/fluidproperties couple/cfd/parttempfield couple/cfd/recurrence deposit "
     "execute forcecontrol/region forcecontrol/region/universe heat heat/gran/radiation indent "
     "insert/pack/dense insert/pack/face insert/pack/face/universe insert/stream/moving "
     "langevin limit/property/atom limit/vel massflow/mesh/face massflow/mesh/face/universe "
     "meanfreetime mesh/surface/stress/6dof mesh/surface/stress/contact nph nph/sphere npt "
     "npt/sphere nve/sph/limit nvt nvt/sllod nvt/sphere particledistribution/discrete/face "
     "particletemplate/fragments pour/legacy press/berendsen property/atom/cumulativetracer "
     "property/atom/lammps property/atom/polydispparcel recenter remove restrain rigid/nph "
     "rigid/npt rigid/nve rigid/nvt rigid/small roughness scale/diameter shake speedcontrol "
     "temp/berendsen temp/rescale tmd wall/harmonic wall/lj1043 wall/lj126 wall/lj93 "
     "wall/reflect wall/sph/general/simple",
     "is not shown to be right for ellipsoids; remove it"},
    {"compute",
     "angle/local coord/gran dihedral/local erotate/rigid heat/flux improper/local ke/rigid "
     "neighbor/atom pair pair/local temp/com temp/deform temp/partial temp/profile temp/ramp "
     "temp/region temp/sphere vacf wall/ghosts",
     "is not shown to be right for ellipsoids; remove it"},
    {"dump", "atom cfg dcd", "is not shown to be right for ellipsoids; remove it"},
    {"pair_style",
     "beck born born/coul/wolf buck buck/coul/cut coul/cut coul/debye coul/dsf coul/wolf dpd "
     "dpd/tstat gauss gran/omp lj/cubic lj/cut lj/cut/coul/cut lj/cut/coul/debye "
     "lj/cut/coul/dsf lj/expand lj/gromacs lj/gromacs/coul/gromacs lj/smooth lj/smooth/linear "
     "lj96/cut mie/cut morse table yukawa zbl",
     "is not shown to be right for ellipsoids; remove it"},
    {"region", "mesh/hex", "is not shown to be right for ellipsoids; remove it"},
    {"run_style", "verlet/implicit", "is not shown to be right for ellipsoids; remove it"},
    {"command",
     "create_multisphere_clump extract_surface extrude_surface fix_update partitioner_style",
     "is not shown to be right for ellipsoids; remove it"},
};

bool is_word_of(const std::string& words, const std::string& word) {
  return (' ' + words + ' ').find(' ' + word + ' ') != std::string::npos;
}

} // namespace

std::string why_unsuited(const std::string& kind, const std::string& style) {
  for (const UnsuitedStyles& row : unsuited_styles)
    if (row.kind == kind && is_word_of(row.styles, style))
      return row.reason_and_remedy;
  return {};
}

} // namespace ellipsoid_host
