// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// fix wall/gran/ellipsoid: walls with the exact contact geometry of ellipsoids.
#ifdef FIX_CLASS
// clang-format off
FixStyle(wall/gran/ellipsoid,FixWallGranEllipsoid)
// clang-format on
#else
#ifndef LMP_FIX_WALL_GRAN_ELLIPSOID_H
#define LMP_FIX_WALL_GRAN_ELLIPSOID_H

#include "batch_notice.h"
#include "ellipsoid_contact_caller.h"
#include "has_law.h"
#include "host_wall.h"
#include "rows_of_particles.h"
#include "update.h"
#include "wall_command.h"
#include "wall_contact_finder.h"
#include "wall_forces.h"
#include "wall_history.h"
#include "wall_meshes.h"

#include <memory>
#include <string>
#include <vector>

namespace LAMMPS_NS {

/// Takes the arguments of fix wall/gran. The host parses them and keeps the lists of near
/// particles; the geometry and the history of the contacts are ours. Forces are computed in batches
/// where the kernel has the chosen laws, else by the host's contact models, one contact after the
/// other.
class FixWallGranEllipsoid : public ellipsoid_host::HostWall,
                             public ellipsoid_host::HasLaw,
                             public ellipsoid_host::SendsRows,
                             public LIGGGHTS::ContactModels::EllipsoidContactCaller {
 public:
  FixWallGranEllipsoid(class LAMMPS* lmp, int narg, char** arg);
  ~FixWallGranEllipsoid() override;
  void post_create() override;
  void pre_delete(bool unfixflag) override;
  void init() override;
  void setup(int vflag) override;
  const std::string& law() const override { return law_; }
  std::string kind() const override { return kind_; }
  void post_force(int vflag) override {
    begin_records(update->ntimestep);
    begin_heat();
    begin_forces();
    FixWallGran::post_force(vflag);
    apply_batch();
  }

  // histories of the contacts beyond the slots that each particle has
  int largest_row() const override;
  double memory_usage() override;
  void copy_arrays(int from, int to, int) override { more_history_.copy(from, to); }
  void set_arrays(int i) override { more_history_.empty(i); }
  int pack_exchange(int i, double* buffer) override { return more_history_.pack(i, buffer); }
  int unpack_exchange(int i, double* buffer) override { return more_history_.unpack(i, buffer); }
  int pack_restart(int i, double* buffer) override { return more_history_.pack(i, buffer); }
  void unpack_restart(int i, int set) override;
  int size_restart(int i) override { return more_history_.packed_size(i); }
  int maxsize_restart() override;

 protected:
  void post_force_primitive(int vflag) override;
  void post_force_mesh(int vflag) override;

 private:
  std::string law_, kind_;
  ellipsoid_host::WallCylinder cylinder_;
  ellipsoid::MulticontactRule rule_ = ellipsoid::MulticontactRule::sum;
  ellipsoid_host::WallMeshes meshes_;
  ellipsoid_host::WallHistory history_;
  ellipsoid_host::RowsOfParticles more_history_;
  ellipsoid_host::RowsOfParticles::Row no_more_; // stays empty
  std::unique_ptr<ellipsoid_host::WallContactFinder> finder_;
  std::vector<ellipsoid::WallContact> contacts_; // of one particle with the wall
  std::vector<char> may_touch_; // per owned particle: touched in the last step, or new lists
  ellipsoid_host::WallForces forces_;
  bool in_batches_ = false; // in this step
  LCM::BatchNotice batch_notice_;

  FixWallGranEllipsoid(class LAMMPS* lmp, int narg, char** arg,
                       const ellipsoid_host::WallCylinder& cylinder);
  template <class Bodies> void choose_finder();
  void choose_laws(const ellipsoid_host::ModelSettings& settings);
  std::string obstacle_to_batches();
  void choose_way();
  void begin_forces();
  void forget_far_contacts();
  ellipsoid::Vector3 primitive_velocity(const ellipsoid::Vector3& point) const;
  bool find_and_apply_contacts(int particle);
  ellipsoid_host::WallHistory::Rows history_of(int particle);
  void apply(int particle, const ellipsoid::WallContact& contact, double* history, double weight);
  ellipsoid::Vector3 velocity_of_wall(int particle, const ellipsoid::WallContact& contact) const;
  void add_to_batch(int particle, const ellipsoid::WallContact& contact, double* history,
                    double weight);
  void apply_batch();
  void act(const ellipsoid_host::ContactWithWall& contact, const ellipsoid::ContactAction& action);
  void record(const ellipsoid_host::ContactWithWall& contact, const ellipsoid::Vector3& force);
  void apply_by_models(int particle, const ellipsoid::WallContact& contact, double* history,
                       double weight);
  void weigh(int particle, const ellipsoid::Vector3& force, const ellipsoid::Vector3& torque,
             double weight);
  /// Into a particle (power), and from the whole wall so far (energy).
  struct Heat {
    double flux = 0.0, total = 0.0;
  };
  Heat present_heat(int particle) const;
  void weigh_heat(int particle, const Heat& before, const ellipsoid::WallContact& contact,
                  double weight);
  void report_to_mesh(const ellipsoid_host::ContactWithWall& contact,
                      const ellipsoid::Vector3& force);
};

} // namespace LAMMPS_NS

#endif
#endif
