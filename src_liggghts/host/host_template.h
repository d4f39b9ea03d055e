// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// Base class of a template of particles to insert, the same for every host.
#pragma once

#include "host_variants.h"

#ifdef ELLIPSOID_HOST_PFM
#include "pfm_template.h"
#else
#include "fix_template_sphere.h"

namespace ellipsoid_host {
using HostTemplate = LAMMPS_NS::FixTemplateSphere;
}
#endif
