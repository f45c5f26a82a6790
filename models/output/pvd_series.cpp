// The .pvd is rewritten after each snapshot; its entries are the snapshots that are complete.
#include <tinyxml2.h>

#include <charconv>
#include <cmath>
#include <cstring>
#include <glisson/core/base/error.hpp>
#include <glisson/models/output/atomic_file.hpp>
#include <glisson/models/output/pvd_series.hpp>
#include <ostream>
#include <system_error>

namespace glisson {
namespace fs = std::filesystem;
namespace {

constexpr std::size_t digits = 6;

std::string number(double value) {
  char text[32];
  return {text, std::to_chars(text, text + sizeof text, value).ptr};
}

std::string numbered(const std::string& stem, std::size_t index) {
  const std::string count = std::to_string(index);
  return stem + "_" + std::string(count.size() < digits ? digits - count.size() : 0, '0') + count;
}

/// Only names that this class gives; anything else in a .pvd is somebody else's and is not touched.
bool is_ours(const std::string& stem, const std::string& file) {
  if (!file.starts_with(stem + "_")) return false;
  const std::size_t start = stem.size() + 1, end = file.find_first_not_of("0123456789", start);
  if (end == std::string::npos || end < start + digits) return false;
  const std::string ending = file.substr(end);
  return ending == ".vtu" || ending == ".vtp" || ending == "_faces.vtp";
}

[[noreturn]] void foreign(const fs::path& path, const std::string& what) {
  throw Error(
      ErrorKind::input,
      what + ", so the series cannot be continued. Choose another output directory, or remove the file.",
      {path.string()});
}

/// One file.
PvdSeries::Entry entry_of(const tinyxml2::XMLElement& element, const std::string& stem,
                          const fs::path& path) {
  const char* time = element.Attribute("timestep");
  const char* file = element.Attribute("file");
  PvdSeries::Entry entry;
  if (time == nullptr || file == nullptr) foreign(path, "a DataSet has no timestep or no file");
  const char* end = time + std::strlen(time);
  const auto [stop, error] = std::from_chars(time, end, entry.time);
  if (error != std::errc{} || stop != end || !std::isfinite(entry.time))
    foreign(path, "timestep '" + std::string(time) + "' is not a number");
  entry.files = {file};
  if (!is_ours(stem, file))
    foreign(path, "it lists '" + std::string(file) + "', which is no snapshot of this series");
  return entry;
}

}  // namespace

PvdSeries::PvdSeries(fs::path directory, std::string stem, VtuOptions options)
    : directory_(std::move(directory)), stem_(std::move(stem)), options_(options) {
  if (stem_.empty() || stem_.find_first_of("/\\\"<>&") != std::string::npos)
    throw Error(ErrorKind::usage,
                "'" + stem_ + "' cannot be the name of a series; use letters, digits, - and _.");
  std::error_code error;
  fs::create_directories(directory_, error);
  if (!fs::is_directory(directory_))
    throw Error(ErrorKind::run, "cannot make the output directory '" + directory_.string() +
                                    "': " + (error ? error.message() : "a file has that name") +
                                    ". Choose another directory.");
}

PvdSeries PvdSeries::resume(fs::path directory, std::string stem, double time, VtuOptions options) {
  PvdSeries series(std::move(directory), std::move(stem), options);
  if (!fs::exists(series.collection())) return series;
  std::vector<std::string> dropped;
  for (Entry& entry : series.listed()) {
    if (entry.time <= time)
      series.entries_.push_back(std::move(entry));
    else
      dropped.insert(dropped.end(), entry.files.begin(), entry.files.end());
  }
  series.fresh_ = false;
  if (dropped.empty()) return series;
  series.write_collection(series.entries_);
  std::error_code ignored;
  for (const std::string& file : dropped) fs::remove(series.directory_ / file, ignored);
  return series;
}

std::vector<PvdSeries::Entry> PvdSeries::listed() const {
  tinyxml2::XMLDocument document;
  const fs::path path = collection();
  if (document.LoadFile(path.c_str()) != tinyxml2::XML_SUCCESS)
    foreign(path, "this is not a complete XML file");
  const tinyxml2::XMLElement* list = document.RootElement();
  list = list == nullptr ? nullptr : list->FirstChildElement("Collection");
  if (list == nullptr) foreign(path, "it holds no Collection");
  std::vector<Entry> entries;
  for (const auto* e = list->FirstChildElement("DataSet"); e != nullptr;
       e = e->NextSiblingElement("DataSet")) {
    const Entry entry = entry_of(*e, stem_, path);
    if (!entries.empty() && entry.time < entries.back().time) foreign(path, "its times go back");
    if (!entries.empty() && entry.time == entries.back().time)
      entries.back().files.push_back(entry.files[0]);
    else
      entries.push_back(entry);
  }
  return entries;
}

/// The old list goes first, so that it never names files of the new run.
void PvdSeries::replace_old_series() {
  fresh_ = false;
  if (!fs::exists(collection())) return;
  std::vector<Entry> old;
  try {
    old = listed();
  } catch (const Error&) {
    return;  // not a series of ours: only the .pvd itself is replaced
  }
  std::error_code ignored;
  fs::remove(collection(), ignored);
  for (const Entry& entry : old)
    for (const std::string& file : entry.files) fs::remove(directory_ / file, ignored);
}

std::string PvdSeries::state() const {
  if (entries_.empty()) return "No snapshot is complete yet.";
  return "The last complete snapshot is '" + (directory_ / entries_.back().files[0]).string() + "' (time " +
         number(entries_.back().time) + ").";
}

void PvdSeries::write(const Mesh& mesh, const Snapshot& snapshot) {
  const double time = snapshot.time;
  if (!std::isfinite(time) || (!entries_.empty() && time < entries_.back().time))
    throw Error(ErrorKind::usage, "a snapshot at time " + number(time) + " cannot follow one at " +
                                      number(entries_.empty() ? 0 : entries_.back().time) +
                                      ". Write snapshots in the order of time.");
  if (fresh_) replace_old_series();
  std::vector<Entry> entries = entries_;
  if (!entries.empty() && entries.back().time == time) entries.pop_back();
  const std::string stem = numbered(stem_, entries.size());
  entries.push_back({time, write_state(directory_, stem, mesh, snapshot, options_, state())});
  write_collection(entries);
  entries_ = std::move(entries);
}

void PvdSeries::write_collection(const std::vector<Entry>& entries) const {
  const auto write = [&](std::ostream& out) {
    out << "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"1.0\">\n<Collection>\n";
    for (const Entry& entry : entries)
      for (std::size_t part = 0; part < entry.files.size(); ++part)
        out << "<DataSet timestep=\"" << number(entry.time) << "\" part=\"" << std::to_string(part)
            << "\" file=\"" << entry.files[part] << "\"/>\n";
    out << "</Collection>\n</VTKFile>\n";
  };
  write_atomically(collection(), write, state());
}

}  // namespace glisson
