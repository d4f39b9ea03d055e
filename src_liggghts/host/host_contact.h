// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// What the host's contact models are told of a contact, under the same names for every host.
#pragma once

#include "contact_interface.h"
#include "host_variants.h"

#ifdef ELLIPSOID_HOST_PFM
#include "pfm_contact.h"
#endif
