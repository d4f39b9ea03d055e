// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#pragma once

#include "atom.h"
#include "contact_models.h"
#include "ellipsoid_host.h"
#include "law/normal_laws.h"
#include "normal_model_base.h"
#include "property_registry.h"
#include "settings.h"

#include <array>
#include <iterator>
#include <string>

namespace LIGGGHTS {
namespace ContactModels {

/// A normal law of the kernel as a contact model of the host, for walls, for plain spheres and for
/// combinations that do not run in batches.
/// @tparam Law see normal_laws.h
template <class Law> class KernelNormalModel : public NormalModelBase {
 public:
  static constexpr std::size_t parameter_count = std::size(Law::parameters);
  /// The functions that make the law's properties.
  using Creators = std::array<MatrixPropertyCreator, parameter_count>;

  KernelNormalModel(LAMMPS* lmp, IContactHistorySetup* setup, class ContactModelBase* base,
                    const Creators& creators)
      : NormalModelBase(lmp, setup, base), creators_(creators) {}

  void registerSettings(Settings& settings) {
    settings.registerOnOff("limitForce", limit_force_, false);
  }
  void postSettings(IContactHistorySetup*, ContactModelBase*) {}

  void connectToProperties(PropertyRegistry& registry) {
    for (std::size_t p = 0; p < parameter_count; ++p) {
      registry.registerProperty(Law::parameters[p], creators_[p], caller_.c_str());
      registry.connect(Law::parameters[p], tables_[p], caller_.c_str());
    }
  }

  inline void surfacesIntersect(SurfacesIntersectData& sidata, ForceData& i_forces,
                                ForceData& j_forces) {
    if (sidata.contact_flags)
      *sidata.contact_flags |= CONTACT_NORMAL_MODEL;
    const ellipsoid::NormalResponse response = Law::response(
        {sidata.deltan, ellipsoid_host::reduced_radius(sidata), sidata.meff, sidata.vn},
        [&](int parameter) {
          return tables_[static_cast<std::size_t>(parameter)][sidata.itype][sidata.jtype];
        });
    sidata.kn = response.stiffness;
    sidata.kt = response.tangential_stiffness;
    sidata.gamman = response.damping;
    sidata.gammat = response.tangential_damping;
    sidata.Fn = limit_force_ && response.force < 0.0 ? 0.0 : response.force;
    ellipsoid_host::add_contact_force(
        sidata, atom->x,
        {sidata.Fn * sidata.en[0], sidata.Fn * sidata.en[1], sidata.Fn * sidata.en[2]},
        ellipsoid_host::TorqueArm::none_on_spheres, i_forces, j_forces);
  }

  inline void surfacesClose(SurfacesCloseData& scdata, ForceData&, ForceData&) {
    if (scdata.contact_flags)
      *scdata.contact_flags &= ~CONTACT_NORMAL_MODEL;
  }

  void beginPass(SurfacesIntersectData&, ForceData&, ForceData&) {}
  void endPass(SurfacesIntersectData&, ForceData&, ForceData&) {}

 private:
  Creators creators_;
  const std::string caller_ = std::string("model ") + Law::style;
  std::array<double**, parameter_count> tables_{}; // per type pair
  bool limit_force_ = false;
};

} // namespace ContactModels
} // namespace LIGGGHTS
