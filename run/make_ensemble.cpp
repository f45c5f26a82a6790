#include <glisson/run/make_ensemble.hpp>

#include <algorithm>
#include <thread>

#include <glisson/core/base/error.hpp>
#include <glisson/run/ensembles.hpp>
#include <glisson/run/gpus.hpp>
#include <glisson/run/simulate.hpp>

namespace glisson {
namespace {

/// Lanes pay while the state of a group stays near the cores: measured on 2 cores with 2 MB of second-level
/// cache each, 1.6 times faster at 5800 nodes and 0.9 times at 9300 (doc/ensembles.md).
constexpr int most_nodes_for_lanes = 8000;

bool same_mesh(const Mesh& a, const Mesh& b) {
  const auto same = [](const Vec3<double>& p, const Vec3<double>& q) {
    return p.x == q.x && p.y == q.y && p.z == q.z;
  };
  if (a.element_count() != b.element_count() || a.triangles != b.triangles) return false;
  for (int e = 0; e < a.element_count(); ++e) {
    const auto p = a.element(e), q = b.element(e);
    if (!std::equal(p.begin(), p.end(), q.begin(), q.end())) return false;
  }
  return std::equal(a.X.begin(), a.X.end(), b.X.begin(), b.X.end(), same);
}

void require_members(const std::vector<Model>& members) {
  if (members.empty()) throw Error(ErrorKind::usage, "An ensemble needs at least one member.");
  for (std::size_t k = 1; k < members.size(); ++k)
    if (!same_mesh(members[0].mesh, members[k].mesh))
      throw Error(ErrorKind::input,
                  "Member " + std::to_string(k) +
                      " has another mesh than member 0, but an ensemble shares one mesh. Run "
                      "it by itself.");
}

detail::GroupDevice gpu_of(const SimulationOptions& options) {
  const int number = cuda::device_number(options.device);
  const bool in_double = options.precision == Precision::double_precision;
  const auto constants = std::make_shared<cuda::ConstantArrays>();
  return {[=] { return detail::open_gpu_group(number, constants); },
          [=, validated = options.validated](const Model& model, std::unique_ptr<cuda::Device> device) {
            if (!validated) validate(model);
            return in_double ? detail::simulate_cuda_double(model, std::move(device))
                             : detail::simulate_cuda_float(model, std::move(device));
          }};
}

}  // namespace

std::unique_ptr<AnyEnsemble> make_ensemble(std::vector<Model> members, const SimulationOptions& options) {
  require_members(members);
  const bool cpu = options.device == "cpu" || options.device == "auto";
  if (options.threads < 0 || options.threads > 1024)
    throw Error(ErrorKind::usage, "A run cannot have " + std::to_string(options.threads) +
                                      " threads. Use 1 to 1024, or 0 for all cores.");
  const int threads = options.threads > 0
                          ? options.threads
                          : std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  // Lanes compute solids together and everything else member by member: without solids nothing is gained.
  const bool small =
      members[0].mesh.element_count() > 0 && members[0].mesh.node_count() <= most_nodes_for_lanes;
  if (cpu && small && options.precision == Precision::single_precision)
    return detail::lane_ensemble(std::move(members), threads, options.instruction_set);
  if (cpu && options.precision == Precision::double_precision)
    return detail::plain_ensemble(std::move(members), threads, detail::simulate_serial_double);
  if (options.device.starts_with("cuda"))
    return detail::device_ensemble(std::move(members), threads, gpu_of(options));
  return detail::plain_ensemble(std::move(members), 1,
                                [options](const Model& model) { return make_simulation(model, options); });
}

}  // namespace glisson
