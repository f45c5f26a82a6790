// Who shares the search for contact on the host.
#pragma once

#include <algorithm>
#include <atomic>
#include <memory>
#include <thread>

#include <glisson/contact/host_parts.hpp>
#include <glisson/core/backend.hpp>
#include <glisson/cpu/team.hpp>

namespace glisson {

/// Each thread takes the next part when it has done one. The team must outlive the result.
inline contact::HostParts parts_of(Team& team) {
  return {team.size(), [&team](int count, const std::function<void(int, int)>& part) {
            std::atomic<int> next{0};
            team.run([&](int worker) {
              for (int i = next++; i < count; i = next++) part(i, worker);
            });
          }};
}

/// The backend's own threads; of a device, whose step waits for the search, a few of the host's.
template <Backend B>
contact::HostParts search_parts(B& backend) {
  constexpr int most = 8;
  if constexpr (requires { parts_of(backend.team()); }) return parts_of(backend.team());
  if constexpr (B::space == Space::host) return {};
  const int cores = static_cast<int>(std::thread::hardware_concurrency());
  auto team = std::make_shared<Team>(std::clamp(cores, 1, most));
  contact::HostParts parts = parts_of(*team);
  parts.run = [team, run = parts.run](int count, const std::function<void(int, int)>& part) {
    run(count, part);
  };
  return parts;
}

}  // namespace glisson
