// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// fix insert/drop: one ellipsoid after the other at a random place of a box, at equal intervals.
#ifdef FIX_CLASS
// clang-format off
FixStyle(insert/drop,FixInsertDrop)
// clang-format on
#else
#ifndef LMP_FIX_INSERT_DROP_H
#define LMP_FIX_INSERT_DROP_H

#include "fix.h"
#include "fix_particletemplate_ellipsoid.h"
#include "host_variants.h"
#include "insertion/solid_body.h"

namespace LAMMPS_NS {

/// All random numbers come from (seed, number of the particle): any number of ranks, and a run
/// continued from a restart file, insert the same particles at the same moments.
class FixInsertDrop : public Fix {
 public:
  FixInsertDrop(class LAMMPS* lmp, int narg, char** arg);

  int setmask() override;
  void init() override;
  void initial_integrate(int vflag) override;
  void pre_exchange() override;
  void reset_timestep(bigint new_step, bigint old_step) override;
  void write_restart(FILE* file) override;
  void restart(ELLIPSOID_RESTART_PARAMETERS) override;
  /// Particles inserted so far.
  double compute_scalar() override { return inserted_; }

  double max_rad(int type) ELLIPSOID_HOST_CONST override;
  double min_rad(int type) ELLIPSOID_HOST_CONST override;
  int min_type() ELLIPSOID_HOST_CONST override { return template_->mintype(); }
  int max_type() ELLIPSOID_HOST_CONST override { return template_->maxtype(); }

 private:
  FixParticletemplateEllipsoid* template_ = nullptr;
  int seed_ = 0;
  int particles_ = 0;            // to insert in all
  double interval_ = 0.0;        // between two drops (time)
  double low_[3] = {0., 0., 0.}; // box of the centres (length)
  double high_[3] = {0., 0., 0.};
  ellipsoid::Vector3 velocity_; // (length/time)
  int inserted_ = 0;
  // Simulated time since the first drop: elapsed_ at since_step_, with steps of time_step_ since.
  double elapsed_ = 0.0;
  bigint since_step_ = 0;
  double time_step_ = 0.0; // 0: not known yet
  double next_try_ = -1.0; // time of it, for a drop whose place was taken; else -1

  void parse(int narg, char** arg);
  void parse_template(ellipsoid_host::ArgumentReader& reader);
  void restart_by_steps(const char* buffer);
  void follow_time_step(bigint last_step);
  void check_interval();
  double elapsed() const;
  void schedule();
  void draw(ParticleToInsertEllipsoid& particle) const;
  bool is_mine(const double* position) const;
  void fractions_in_box(const double* x, double* fractions) const;
  bool is_inside_box() const;
  ellipsoid::SolidBody solid_body(const ellipsoid::Vector3& centre, const double* semiaxes,
                                  const double* quaternion, int spacing) const;
  bool place_is_free(const ParticleToInsertEllipsoid& particle) const;
  void insert(ParticleToInsertEllipsoid& particle);
};

} // namespace LAMMPS_NS

#endif
#endif
