// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// What computes pair/ellipsoid/local and wall/ellipsoid/local share: a row per contact.
#pragma once

#include "ellipsoid_contact_caller.h"
#include "host_compute.h"

#include <vector>

namespace LAMMPS_NS {

class EllipsoidContactList : public ellipsoid_host::HostCompute {
 public:
  void compute_local() override;
  double memory_usage() override;

 protected:
  using ContactRecord = LIGGGHTS::ContactModels::ContactRecord;
  using EllipsoidContactCaller = LIGGGHTS::ContactModels::EllipsoidContactCaller;

  enum class ContactPartner { particle, wall };

  EllipsoidContactList(ELLIPSOID_COMPUTE_PARAMETERS, ContactPartner partner);

  /// The contacts of these, in this order. Called in every init().
  void set_callers(const std::vector<EllipsoidContactCaller*>& callers);

 private:
  enum class Property : int; // in the order of the words on the pages

  ContactPartner partner_;
  std::vector<EllipsoidContactCaller*> callers_;
  std::vector<Property> properties_;
  std::vector<double> values_;
  std::vector<double*> rows_;

  int width(Property property) const;
  /// Whether this rank lists the contact; the particle with the smaller id comes first then.
  bool arrange(ContactRecord& record) const;
  void append(const ContactRecord& record, int caller);
  void append(const ContactRecord& record, int caller, Property property);
  void append(const ellipsoid::Vector3& v);
};

} // namespace LAMMPS_NS
