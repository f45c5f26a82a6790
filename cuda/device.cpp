#include <glisson/cuda/device.hpp>

#include <charconv>

#include <glisson/core/base/error.hpp>
#include <glisson/cuda/device_group.hpp>

namespace glisson::cuda {
namespace {

constexpr const char* advice = " Use --device cpu, or --device auto to let Glisson choose.";

std::string megabytes(std::size_t bytes) {
  return std::to_string((bytes + (std::size_t{1} << 20) - 1) >> 20) + " MiB";
}

/// What a status code means for the user; empty: nothing special.
std::string meaning(int code, const DeviceFacts& facts) {
  const std::string capability = std::to_string(facts.major) + "." + std::to_string(facts.minor);
  switch (code) {
    case status::old_driver:
      return "This machine has no NVIDIA driver, or one that is older than this build's CUDA.";
    case status::no_device:
      return "This machine has no CUDA device that this process may use.";
    case status::no_kernel_image:
    case status::unsupported_ptx:
      return "This build holds no code for compute capability " + capability +
             ". Build it with -DGLISSON_CUDA_ARCHITECTURES=" + std::to_string(facts.major) +
             std::to_string(facts.minor) + ".";
    case status::ecc_error:
      return "Its memory reported an error that could not be corrected; the results of this run are lost.";
    case status::illegal_address:
    case status::launch_failure:
      return "A kernel failed and the device is lost to this process. Please report it with the input file; "
             "go on "
             "from the last checkpoint with --resume.";
    default:
      return "";
  }
}

}  // namespace

std::vector<DeviceFacts> find_devices(const Runtime& runtime) {
  int count = 0;
  if (runtime.device_count(&count) != status::done) {
    runtime.launch_status();  // forgets the error
    return {};
  }
  std::vector<DeviceFacts> devices;
  for (int d = 0; d < count; ++d) {
    DeviceFacts facts;
    if (runtime.describe(d, &facts) != status::done) break;
    devices.push_back(facts);
  }
  return devices;
}

int device_number(std::string_view name) {
  if (name == "cuda") return 0;
  constexpr std::string_view prefix = "cuda:";
  int number = -1;
  if (name.starts_with(prefix)) {
    const char *first = name.data() + prefix.size(), *last = name.data() + name.size();
    const auto [end, code] = std::from_chars(first, last, number);
    if (code == std::errc() && end == last && number >= 0) return number;
  }
  throw Error(ErrorKind::usage, "There is no device '" + std::string(name) +
                                    "'. Choose auto, cpu, serial, cuda or cuda:N with N from 0.");
}

Device::Device(const Runtime& runtime, int number) : runtime_(runtime), number_(number), queue_(runtime) {
  int count = 0;
  check(runtime_.device_count(&count), "looking for devices");
  if (count == 0) fail(status::no_device, "looking for devices");
  if (number >= count)
    throw Error(ErrorKind::device,
                "There is no device " + named() + ": this machine has " + std::to_string(count) +
                    ", cuda:0 to cuda:" + std::to_string(count - 1) + ". See glisson devices.");
  check(runtime_.describe(number, &facts_), "asking for its properties");
  select();
  check(runtime_.check_kernels(), "looking for code that it can run");
  check(runtime_.create_stream(&stream_), "creating a stream");
}

Device::Device(DeviceGroup& group, GroupMember& member)
    : runtime_(group.device_.runtime_),
      number_(group.device_.number_),
      facts_(group.device_.facts_),
      stream_(group.device_.stream_),
      queue_(runtime_),
      group_(&group),
      member_(&member) {
  member.waiting = &queue_.waiting();
}

Device::~Device() {
  if (group_) member_->waiting = nullptr;
  if (runtime_.select(number_) != status::done) return;
  if (pinned_used_ > 0) runtime_.wait(stream_);  // launches may still read it
  if (pinned_) runtime_.release_pinned(pinned_);
  if (!group_) runtime_.destroy_stream(stream_);
}

void* Device::allocate(std::size_t bytes) {
  if (bytes == 0) return nullptr;
  send();
  void* memory = nullptr;
  const int code = runtime_.allocate(&memory, bytes);
  if (code == status::out_of_memory) fail_allocation(bytes);
  check(code, "allocating memory");
  const int cleared = runtime_.clear(memory, bytes, stream_);
  if (cleared != status::done) {
    runtime_.release(memory);
    fail(cleared, "clearing memory");
  }
  return memory;
}

// What waits may use the memory. A member sends it by itself: its loop must not stand while an exception goes
// through it. A failure here has been, or will be, reported by a call that can throw.
void Device::release(void* memory) noexcept {
  if (!memory || runtime_.select(number_) != status::done) return;
  if (const int code = queue_.send(stream_)) late_ = code;
  if (!group_ || !group_->constants_->release(runtime_, memory)) runtime_.release(memory);
}

void* Device::share(const void* from, std::size_t bytes) {
  if (!group_ || bytes == 0) return nullptr;
  select();
  void* memory = nullptr;
  const int code = group_->constants_->get(runtime_, stream_, from, bytes, &memory);
  if (code == status::out_of_memory) fail_allocation(bytes);
  check(code, "copying to it");
  return memory;
}

void Device::copy_in(const void* from, void* to, std::size_t bytes) {
  if (bytes == 0) return;
  send();
  check(runtime_.copy_in(from, to, bytes, stream_), "copying to it");
}

void Device::copy_out(const void* from, void* to, std::size_t bytes) {
  if (bytes == 0) return;
  send();
  check(runtime_.copy_out(from, to, bytes, stream_), "copying from it");
}

void Device::wait() {
  if (in_loop()) {
    select();
    check(late_, "launching a kernel");
    group_->stand(*member_, true);
  } else {
    send();
    check(runtime_.wait(stream_), "waiting for it");
  }
  pinned_used_ = 0;
}

void Device::step_done() {
  queue_.waiting().end_step();
  if (queue_.size() >= (group_ ? DeviceGroup::enough_waiting : enough_waiting)) send();
}

unsigned* Device::place_to_copy_in(std::size_t bytes) {
  return group_ && bytes <= most_to_copy_in ? place_of(bytes) : nullptr;
}

unsigned* Device::place_to_copy_out(std::size_t bytes) {
  return group_ && bytes <= most_to_copy_out ? place_of(bytes) : nullptr;
}

unsigned* Device::place_for_joint_copies(std::size_t bytes) {
  return bytes <= most_to_copy_out ? place_of(bytes) : nullptr;
}

unsigned* Device::place_of(std::size_t bytes) {
  if (bytes == 0 || bytes % sizeof(unsigned) != 0) return nullptr;
  if (pinned_used_ + bytes > pinned_bytes_ && pinned_used_ > 0) wait();
  if (bytes > pinned_bytes_) {
    constexpr std::size_t grain = 64 << 10;
    if (pinned_) runtime_.release_pinned(pinned_);
    pinned_ = nullptr;
    pinned_bytes_ = (bytes + grain - 1) / grain * grain;
    select();
    void* memory = nullptr;
    if (runtime_.allocate_pinned(&memory, pinned_bytes_) != status::done) {
      runtime_.launch_status();  // forgets the error: ordinary copies need none
      pinned_bytes_ = 0;
      return nullptr;
    }
    pinned_ = static_cast<std::byte*>(memory);
  }
  std::byte* place = pinned_ + pinned_used_;
  pinned_used_ += (bytes + 15) / 16 * 16;
  return reinterpret_cast<unsigned*>(place);
}

bool Device::in_loop() const { return group_ && member_->loop.inside(); }

void Device::select() { check(runtime_.select(number_), "selecting it"); }

void Device::send() {
  select();
  check(late_, "launching a kernel");
  if (!in_loop())
    check(queue_.send(stream_), "launching a kernel");
  else if (queue_.size() > 0)
    group_->stand(*member_, false);
}

std::string Device::named() const {
  const std::string name = "cuda:" + std::to_string(number_);
  return facts_.name.empty() ? name : name + " (" + facts_.name + ")";
}

void Device::fail(int code, const char* doing) const {
  std::string text = "The device " + named() + " failed while " + doing + ": " + runtime_.text(code) +
                     " (CUDA error " + std::to_string(code) + ").";
  const std::string why = meaning(code, facts_);
  if (!why.empty()) text += " " + why;
  throw Error(ErrorKind::device, text + advice);
}

void Device::fail_allocation(std::size_t bytes) const {
  runtime_.launch_status();  // forgets the error: memory can be freed and asked for again
  std::size_t available = 0, total = 0;
  std::string text = "The device " + named() + " has no room for another " + megabytes(bytes);
  if (runtime_.memory_info(&available, &total) == status::done)
    text += ": " + megabytes(available) + " of " + megabytes(total) + " are free";
  throw Error(
      ErrorKind::device,
      text + ". Use --precision single, a coarser mesh or --device cpu, or end what else runs on it.");
}

}  // namespace glisson::cuda
