// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "fix_wall_gran_ellipsoid.h"

#include "atom.h"
#include "comm.h"
#include "ellipsoid_host.h"
#include "ellipsoid_models.h"
#include "error.h"
#include "fix_pair_settings_ellipsoid.h"
#include "fix_property_atom.h"
#include "force.h"
#include "host_mesh.h"
#include "input.h"
#include "model_settings.h"
#include "modify.h"
#include "neighbor.h"
#include "primitive_wall.h"
#include "surface_settings.h"
#include "wall_command.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <string>

using namespace LAMMPS_NS;
using ellipsoid::Vector3;
using ellipsoid::WallContact;
using ellipsoid_host::store;
using ellipsoid_host::vector;
using ellipsoid_host::WallMeshes;

namespace {

/// The name of the command in work is a protected member of the host's Input: a derived class may
/// reach it.
struct CommandInWork : Input {
  static const char* name(Input& input) { return input.*(&CommandInWork::command); }
};

bool is_work_of(Input& input, const char* command) {
  const char* const name = CommandInWork::name(input);
  return name && std::strcmp(name, command) == 0;
}

} // namespace

FixWallGranEllipsoid::FixWallGranEllipsoid(LAMMPS* lmp, int narg, char** arg)
    : FixWallGranEllipsoid(lmp, narg, arg, ellipsoid_host::check_wall_command(lmp, narg, arg)) {}

FixWallGranEllipsoid::FixWallGranEllipsoid(LAMMPS* lmp, int narg, char** arg,
                                           const ellipsoid_host::WallCylinder& cylinder)
    : HostWall(lmp, narg, arg), // which leaves iarg_ where the settings of the models begin
      law_(ellipsoid_host::wall_law(lmp, narg, arg, iarg_)),
      kind_(ellipsoid_host::wall_kind(narg, arg)), cylinder_(cylinder), meshes_(lmp) {
  const bool multisphere = models().contact_match("surface", "multisphere");
  if (!multisphere && !models().contact_match("surface", "smooth"))
    error->fix_error(FLERR, this,
                     "needs 'surface smooth' or 'surface multisphere' among the models; add it");
  const std::string complaint = LCM::unsuitable_setting(narg, arg);
  if (!complaint.empty())
    error->fix_error(FLERR, this, complaint.c_str());
  const ellipsoid_host::ModelSettings settings(narg - iarg_, arg + iarg_);
  if (multisphere) {
    choose_finder<ellipsoid_host::MultisphereBodies>();
    rule_ = LCM::MulticontactSetting::in(settings);
  } else {
    choose_finder<ellipsoid_host::SmoothEllipsoids>();
  }
  const int at_primitive = cylinder_.axis >= 0 ? 2 : 1; // tips of a smooth ellipsoid
  const bool many = multisphere || is_mesh_wall();
  history_.set_size(many ? LCM::ContactsSetting::in(settings) : at_primitive, dnum());
  choose_laws(settings);
  restart_peratom = 1;
  create_attribute = 1;
  atom->add_callback(0);
  atom->add_callback(1);
}

FixWallGranEllipsoid::~FixWallGranEllipsoid() {
  atom->delete_callback(id, 0);
  atom->delete_callback(id, 1);
}

int FixWallGranEllipsoid::largest_row() const {
  return more_history_.largest_packed_size(atom->nlocal);
}

double FixWallGranEllipsoid::memory_usage() {
  return FixWallGran::memory_usage() + more_history_.bytes();
}

void FixWallGranEllipsoid::unpack_restart(int i, int set) {
  more_history_.unpack_extra(i, atom->extra[i], set);
}

int FixWallGranEllipsoid::maxsize_restart() {
  const int largest = largest_row();
  int of_all = largest;
  MPI_Allreduce(&largest, &of_all, 1, MPI_INT, MPI_MAX, world);
  return of_all;
}

/// Of walls the host counts the values that models remember, and does not keep their names: they
/// lie in the order of the models.
void FixWallGranEllipsoid::choose_laws(const ellipsoid_host::ModelSettings& settings) {
  constexpr int of_a_law = 3; // values
  int next = 0;
  forces_.models().choose(
      [this](const std::string& kind, const std::string& name) {
        return models().contact_match(kind, name);
      },
      settings, [&next](const std::string&) { return (next += of_a_law) - of_a_law; });
  if (forces_.models().run_in_batches() && next != dnum())
    error->fix_error(FLERR, this,
                     ("internal error: the contact models remember " + std::to_string(dnum()) +
                      " values of a contact, their batched laws " + std::to_string(next))
                         .c_str());
}

/// @tparam Bodies what the particles are: SmoothEllipsoids or MultisphereBodies
template <class Bodies> void FixWallGranEllipsoid::choose_finder() {
  using namespace ellipsoid_host;
  if (is_mesh_wall())
    finder_.reset(new MeshContactFinder<Bodies>(lmp, meshes_));
  else if (cylinder_.axis >= 0)
    finder_.reset(new CylinderContactFinder<Bodies>(lmp, cylinder_.axis, cylinder_.radius,
                                                    vector(cylinder_.centre)));
  else
    finder_.reset(new PlaneContactFinder<Bodies>(lmp, primitive_wall()));
}

void FixWallGranEllipsoid::post_create() {
  ellipsoid_host::compare_with_restart(lmp, id, *this);
  const int values = dnum();
  setDnum(0); // the host need not make a history of its own
  FixWallGran::post_create();
  setDnum(values);
  if (values == 0)
    return;
  const std::string name = std::string("history_") + id;
  std::vector<std::string> words{name, "all", "property/atom", name, "vector", "yes", "no", "no"};
  words.insert(words.end(), static_cast<std::size_t>(history_.size()), "0.");
  std::vector<char*> arguments;
  for (std::string& word : words)
    arguments.push_back(&word[0]);
  modify->add_fix(static_cast<int>(arguments.size()), arguments.data());
  set_history(static_cast<FixPropertyAtom*>(modify->find_fix_property(
      name.c_str(), "property/atom", "vector", history_.size(), 0, style)));
}

/// Refuses a second command of the same ID: the host would replace the first in its list of fixes,
/// which goes wrong because fixes that the wall has made leave the list meanwhile.
void FixWallGranEllipsoid::pre_delete(bool unfixflag) {
  if (unfixflag && is_work_of(*input, "fix"))
    error->fix_error(FLERR, this,
                     "is defined already; use another id, or 'unfix' the former wall before");
  FixWallGran::pre_delete(unfixflag);
}

void FixWallGranEllipsoid::init() {
  FixWallGran::init();
  check_heat();
  if (!atom->superquadric_flag)
    error->fix_error(FLERR, this, "needs particles with shape: use atom_style granular/ellipsoid");
  for (int m = 0; m < n_FixMesh_; ++m)
    if (ellipsoid_host::weighs_contacts(FixMesh_list_[m]))
      error->fix_error(FLERR, this,
                       "has one contact at a seam by itself: remove 'weighted_wall_formulation' "
                       "from its meshes");
  forces_.models().connect(force->registry, force->nktv2p == 1.0);
  choose_way();
}

/// The host finds out here, after the forces of the set-up, whether heat goes through the wall.
void FixWallGranEllipsoid::setup(int vflag) {
  FixWallGran::setup(vflag);
  choose_way();
}

/// Whether forces are computed in batches; says so if that has changed.
void FixWallGranEllipsoid::choose_way() {
  const std::string obstacle = obstacle_to_batches();
  in_batches_ = obstacle.empty();
  batch_notice_.tell(*lmp, "fix wall/gran/ellipsoid (id " + std::string(id) + ")", obstacle);
}

/// Why the forces of this run do not go through batches, or an empty string.
std::string FixWallGranEllipsoid::obstacle_to_batches() {
  if (heattransfer_flag_)
    return "heat does not run in batches";
  if (fix_rigid_)
    return "particles of rigid bodies do not run in batches";
  if (stores_of_contacts())
    return "what is stored of single contacts does not run in batches";
  return forces_.models().obstacle();
}

/// Before the contacts of a step.
void FixWallGranEllipsoid::begin_forces() {
  if (in_batches_)
    forces_.begin_step(*atom);
}

void FixWallGranEllipsoid::post_force_primitive(int) {
  finder_->begin_step();
  const auto count = static_cast<std::size_t>(atom->nlocal);
  if (neighbor->ago == 0 || may_touch_.size() != count)
    may_touch_.assign(count, 1);
  int* near;
  const int near_count = primitive_wall().getNeighbors(near);
  for (int k = 0; k < near_count; ++k)
    if (atom->mask[near[k]] & groupbit)
      find_and_apply_contacts(near[k]);
}

void FixWallGranEllipsoid::post_force_mesh(int) {
  finder_->begin_step();
  for (int m = 0; m < n_FixMesh_; ++m)
    FixMesh_list_[m]->contactHistory()->markAllContacts();
  if (meshes_.update(FixMesh_list_, n_FixMesh_, groupbit)) {
    may_touch_.assign(static_cast<std::size_t>(atom->nlocal), 1);
    if (dnum() > 0)
      forget_far_contacts();
  }
  meshes_.for_each_particle([this](int i) {
    if (find_and_apply_contacts(i))
      for (int m = 0; m < n_FixMesh_; ++m)
        FixMesh_list_[m]->contactHistory()->cleanUpContacts(i, i + 1);
  });
}

/// Particles without near triangles have no contacts.
void FixWallGranEllipsoid::forget_far_contacts() {
  std::vector<char> is_near(static_cast<std::size_t>(atom->nlocal), 0);
  meshes_.for_each_particle([&](int i) { is_near[static_cast<std::size_t>(i)] = 1; });
  contacts_.clear();
  for (std::size_t i = 0; i < is_near.size(); ++i)
    if (!is_near[i])
      history_.forget(history_of(static_cast<int>(i)));
}

/// Of the wall's surface at a point in space. A cylinder that is not shifted along its axis turns
/// about it, with the angular velocity `shear`.
Vector3 FixWallGranEllipsoid::primitive_velocity(const Vector3& point) const {
  double velocity[3] = {0.0, 0.0, 0.0};
  if (!shear_)
    return {};
  if (cylinder_.axis < 0 || shearDim_ == cylinder_.axis) {
    velocity[shearDim_] = vshear_;
    return vector(velocity);
  }
  velocity[cylinder_.axis] = vshear_;
  return cross(vector(velocity), point - vector(cylinder_.centre));
}

/// Returns whether there is, or may have been in the last step, a contact.
bool FixWallGranEllipsoid::find_and_apply_contacts(int i) {
  char& may_touch = may_touch_[static_cast<std::size_t>(i)];
  finder_->find(i, contacts_);
  if (contacts_.empty() && !may_touch)
    return false;
  may_touch = contacts_.empty() ? 0 : 1;
  const bool remembers = dnum() > 0;
  const ellipsoid_host::WallHistory::Rows rows =
      remembers ? history_of(i) : ellipsoid_host::WallHistory::Rows{};
  if (remembers)
    history_.assign(contacts_, rows, meshes_);
  const double weight = multicontact_weight(rule_, std::max(1, static_cast<int>(contacts_.size())));
  for (std::size_t k = 0; k < contacts_.size(); ++k)
    apply(i, contacts_[k], remembers ? history_.values(rows, k) : nullptr, weight);
  return true;
}

/// The slots of a particle's contacts with the wall, of this and of the last step.
ellipsoid_host::WallHistory::Rows FixWallGranEllipsoid::history_of(int i) {
  const bool has_more =
      static_cast<int>(contacts_.size()) > history_.slots() || !more_history_.of(i).empty();
  return {history_values(i), has_more ? &more_history_.at(i) : &no_more_};
}

/// @param[in] weight of the force in the sum
void FixWallGranEllipsoid::apply(int i, const WallContact& contact, double* history,
                                 double weight) {
  if (in_batches_)
    add_to_batch(i, contact, history, weight);
  else
    apply_by_models(i, contact, history, weight);
}

Vector3 FixWallGranEllipsoid::velocity_of_wall(int i, const WallContact& contact) const {
  return contact.triangle >= 0 ? meshes_.velocity(contact.triangle, contact.foot)
                               : primitive_velocity(vector(x_[i]) + contact.point);
}

void FixWallGranEllipsoid::add_to_batch(int i, const WallContact& contact, double* history,
                                        double weight) {
  ellipsoid_host::ContactWithWall with_wall{i,      atom_type_wall_, history,
                                            weight, contact,         velocity_of_wall(i, contact)};
  if (contact.triangle >= 0) {
    const WallMeshes::NearTriangle& triangle = meshes_.near(contact.triangle);
    with_wall.mesh = triangle.mesh;
    with_wall.triangle = triangle.index;
    with_wall.wall_type = FixMesh_list_[triangle.mesh]->atomTypeWall();
    ellipsoid_host::note_triangle(FixMesh_list_[triangle.mesh], i, triangle.id);
  }
  forces_.add(with_wall);
  if (forces_.is_full())
    apply_batch();
}

void FixWallGranEllipsoid::apply_batch() {
  if (in_batches_)
    forces_.solve_and_clear(
        update->dt, computeflag_ && shearupdate_,
        [this](const ellipsoid_host::ContactWithWall& contact,
               const ellipsoid::ContactAction& action) { act(contact, action); });
}

/// Forces are added up in the order of the contacts.
void FixWallGranEllipsoid::act(const ellipsoid_host::ContactWithWall& contact,
                               const ellipsoid::ContactAction& action) {
  if (!computeflag_)
    return;
  const int i = contact.particle;
  const Vector3 force = contact.weight * action.force;
  store(vector(f_[i]) + force, f_[i]);
  store(vector(atom->torque[i]) + contact.weight * action.torque_i, atom->torque[i]);
  if (store_force_)
    store(vector(wallforce_[i]) + force, wallforce_[i]);
  if (keeps_records())
    record(contact, action.force);
  if (contact.mesh >= 0)
    report_to_mesh(contact, force);
}

/// @param[in] force before it is weighed
void FixWallGranEllipsoid::record(const ellipsoid_host::ContactWithWall& contact,
                                  const Vector3& force) {
  const WallContact& geometry = contact.geometry;
  LCM::SurfacesIntersectData data;
  data.is_wall = true;
  data.i = contact.particle;
  data.j = contact.triangle;
  data.deltan = geometry.overlap;
  data.reff = geometry.reduced_radius;
  store(vector(x_[contact.particle]) + geometry.point, data.contact_point);
  store(-geometry.normal, data.en);
  set_spheres(geometry.sphere, -1, contact.weight);
  add_record(data, force, *atom,
             contact.mesh >= 0 ? FixMesh_list_[contact.mesh]->triMesh() : nullptr);
}

/// @param[in] weight of the force in the sum
void FixWallGranEllipsoid::apply_by_models(int i, const WallContact& contact, double* history,
                                           double weight) {
  LCM::SurfacesIntersectData data;
  data.is_wall = true;
  data.is_non_spherical = true;
  data.i = i;
  data.contact_history = history;
  data.deltan = contact.overlap;
  data.reff = data.radi = curvature_radius_i = contact.reduced_radius;
  store(vector(x_[i]) + contact.point, data.contact_point);
  store(-contact.normal, data.delta); // the host's normal: from the wall to the particle
  FixMeshSurface* mesh = nullptr;
  if (contact.triangle >= 0) {
    mesh = FixMesh_list_[meshes_.near(contact.triangle).mesh];
    atom_type_wall_ = mesh->atomTypeWall();
    ellipsoid_host::note_triangle(mesh, i, meshes_.near(contact.triangle).id);
  }
  const Vector3 velocity = velocity_of_wall(i, contact);
  double wall_velocity[3];
  store(velocity, wall_velocity);
  set_spheres(contact.sphere, -1, weight);
  const Vector3 force = vector(f_[i]), torque = vector(atom->torque[i]);
  const Heat heat = present_heat(i);
  apply_models(data, wall_velocity, mesh, mesh ? meshes_.near(contact.triangle).mesh : 0,
               mesh ? meshes_.near(contact.triangle).index : 0);
  if (weight != 1.0)
    weigh(i, force, torque, weight);
  if (heattransfer_flag_)
    weigh_heat(i, heat, contact, weight);
  if (mesh && computeflag_)
    report_to_mesh({i, 0, nullptr, weight, contact, velocity, meshes_.near(contact.triangle).mesh,
                    meshes_.near(contact.triangle).index},
                   vector(f_[i]) - force);
}

void FixWallGranEllipsoid::weigh(int i, const Vector3& force, const Vector3& torque,
                                 double weight) {
  const Vector3 excess = (weight - 1.0) * (vector(f_[i]) - force);
  store(vector(f_[i]) + excess, f_[i]);
  store(torque + weight * (vector(atom->torque[i]) - torque), atom->torque[i]);
  if (store_force_)
    store(vector(wallforce_[i]) + excess, wallforce_[i]);
}

FixWallGranEllipsoid::Heat FixWallGranEllipsoid::present_heat(int i) const {
  return heattransfer_flag_ ? Heat{fppa_hf->vector_atom[i], Q_add} : Heat{};
}

/// The host's conductance is proportional to the square root of the area in which a sphere
/// (sphere_of_heat()) overlaps a plane; there is none where the sphere is beyond the wall. Here
/// that area becomes the one of the contact's reduced radius.
void FixWallGranEllipsoid::weigh_heat(int i, const Heat& before, const WallContact& contact,
                                      double weight) {
  const double sphere = sphere_of_heat(i, curvature_radius_i);
  double share = weight;
  if (sphere > 0.0) {
    const double depth = depth_of_heat(i, contact.overlap);
    const double area = 2.0 * contact.reduced_radius - depth; // over pi depth
    const double of_host = 2.0 * sphere - depth;
    if (area <= 0.0 || of_host <= 0.0) {
      fppa_hf->vector_atom[i] = before.flux;
      Q_add = before.total;
      return;
    }
    share *= std::sqrt(area / of_host);
  }
  double& flux = fppa_hf->vector_atom[i];
  flux = before.flux + share * (flux - before.flux);
  Q_add = before.total + share * (Q_add - before.total);
}

/// Force and torque on the mesh, stress and wear of the triangle, drive of servo walls.
/// @param[in] force that the particle feels
void FixWallGranEllipsoid::report_to_mesh(const ellipsoid_host::ContactWithWall& contact,
                                          const Vector3& force) {
  double force_on_particle[3], lever[3], velocity[3];
  store(force, force_on_particle);
  store(contact.geometry.point, lever);
  store(contact.velocity, velocity);
  ellipsoid_host::add_to_mesh(FixMesh_list_[contact.mesh], contact.particle, force_on_particle,
                              lever, contact.triangle, velocity);
}
