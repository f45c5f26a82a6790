// Columns arrive one after the other, rows are wanted: the columns wait in a binary file and are read back in
// bands of rows.
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <glisson/core/base/error.hpp>
#include <glisson/models/output/atomic_file.hpp>
#include <glisson/models/output/text_writer.hpp>
#include <limits>
#include <ostream>

namespace glisson {
namespace {

constexpr std::size_t band_bytes = 16 << 20;
constexpr int significant_digits = 9;

void append_number(std::string& text, double value) {
  char digits[40];
  text.append(digits, std::to_chars(digits, digits + sizeof digits, value, std::chars_format::general,
                                    significant_digits)
                          .ptr);
}

}  // namespace

/// The file of one variable: [rows] as a double, then per snapshot [time][row values].
struct TextWriter::Columns {
  std::string name;
  std::filesystem::path text, binary;
  detail::Descriptor file{-1};
  std::int64_t rows = -1;                                  ///< -1: not known before the first snapshot
  std::int64_t count = 0;                                  ///< of snapshots
  double last = -std::numeric_limits<double>::infinity();  ///< time of the last one [s]

  std::int64_t record_bytes() const { return (rows + 1) * static_cast<std::int64_t>(sizeof(double)); }
  std::int64_t end_of(std::int64_t snapshots) const {
    return static_cast<std::int64_t>(sizeof(double)) + snapshots * record_bytes();
  }

  void open(int flags) {
    file.value = ::open(binary.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | flags, 0666);
    if (file.value < 0) throw Error(ErrorKind::run, detail::write_failure(binary, errno, 0, 0));
  }

  bool read_at(std::int64_t offset, double* values, std::int64_t n) const {
    auto* bytes = reinterpret_cast<char*>(values);
    std::int64_t left = n * static_cast<std::int64_t>(sizeof(double));
    while (left > 0) {
      const ssize_t got = ::pread(file.value, bytes, static_cast<std::size_t>(left), offset);
      if (got < 0 && errno == EINTR) continue;
      if (got <= 0) return false;
      bytes += got;
      offset += got;
      left -= got;
    }
    return true;
  }

  void append(double time, const Field& field) {
    const auto size = static_cast<std::int64_t>(field.value_count());
    if (rows < 0) start(size);
    if (rows != size)
      throw Error(ErrorKind::usage, "variable " + name + " had " + std::to_string(rows) +
                                        " values and now has " + std::to_string(size) +
                                        ". One series belongs to one mesh.");
    if (count > 0 && time == last) keep(count - 1);  // a restart may repeat the snapshot it started from
    detail::FileBuffer buffer(file.value);
    put(buffer, {&time, 1});
    field.for_each_piece([&](std::span<const double> values) { put(buffer, values); });
    if (!buffer.flush()) undo(buffer);
    ++count;
    last = time;
  }

  void start(std::int64_t row_count) {
    rows = row_count;
    const double stored = static_cast<double>(rows);
    detail::FileBuffer buffer(file.value);
    put(buffer, {&stored, 1});
    if (!buffer.flush()) undo(buffer);
  }

  static void put(detail::FileBuffer& buffer, std::span<const double> values) {
    buffer.sputn(reinterpret_cast<const char*>(values.data()),
                 static_cast<std::streamsize>(values.size_bytes()));
  }

  [[noreturn]] void undo(const detail::FileBuffer& buffer) {
    const std::string message =
        detail::write_failure(binary, buffer.error(), buffer.needed(), buffer.written());
    std::string kept = " The " + std::to_string(count) + " earlier snapshots are kept.";
    if (::ftruncate(file.value, end_of(count)) != 0 || ::lseek(file.value, 0, SEEK_END) < 0) kept.clear();
    throw Error(ErrorKind::run, message + kept);
  }

  /// Keeps the columns up to `time`; the file must be one that append() wrote.
  void cut_after(double time) {
    struct stat status {};
    double stored = 0;
    if (::fstat(file.value, &status) != 0 || status.st_size == 0) return;
    if (!read_at(0, &stored, 1) || !(stored >= 0) || stored > 1e12)
      throw Error(ErrorKind::input,
                  "this is no file of columns, so the text output cannot be continued. Remove it.",
                  {binary.string()});
    rows = static_cast<std::int64_t>(stored);
    double of_column = 0;
    while (end_of(count + 1) <= status.st_size && read_at(end_of(count), &of_column, 1) && of_column <= time)
      ++count;
    keep(count);
  }

  /// Cuts off all but the first snapshots and goes to the end.
  void keep(std::int64_t snapshots) {
    count = snapshots;
    if (rows < 0) return;
    if (::ftruncate(file.value, end_of(count)) != 0 || ::lseek(file.value, 0, SEEK_END) < 0)
      throw Error(ErrorKind::run, detail::write_failure(binary, errno, 0, 0));
    if (count > 0 && !read_at(end_of(count - 1), &last, 1)) last = -std::numeric_limits<double>::infinity();
  }

  void write_rows(std::ostream& out) const {
    if (count == 0) return;
    const auto columns = static_cast<std::size_t>(count);
    const auto band =
        static_cast<std::int64_t>(std::max<std::size_t>(1, band_bytes / (columns * sizeof(double))));
    std::vector<double> values;
    std::string line;
    for (std::int64_t first = 0; first < rows; first += band) {
      const std::int64_t n = std::min(band, rows - first);
      values.resize(static_cast<std::size_t>(n) * columns);
      for (std::int64_t c = 0; c < count; ++c) {
        const std::int64_t offset = end_of(c) + (1 + first) * static_cast<std::int64_t>(sizeof(double));
        if (!read_at(offset, values.data() + c * n, n))
          throw Error(ErrorKind::run,
                      "'" + binary.string() + "' cannot be read back; somebody has changed it.");
      }
      for (std::int64_t r = 0; r < n; ++r) {
        line.clear();
        for (std::int64_t c = 0; c < count; ++c) {
          if (c > 0) line += rows == 1 ? '\n' : ' ';  // energies: one value per line
          append_number(line, values[static_cast<std::size_t>(c * n + r)]);
        }
        out << line << '\n';
      }
    }
  }
};

TextWriter::TextWriter(TextWriter&&) noexcept = default;
TextWriter& TextWriter::operator=(TextWriter&&) noexcept = default;
TextWriter::~TextWriter() = default;
TextWriter::TextWriter(Empty) {}

TextWriter::TextWriter(std::string prefix, const std::vector<std::string>& variables)
    : TextWriter(resume(std::move(prefix), variables, -std::numeric_limits<double>::infinity())) {}

TextWriter TextWriter::resume(const std::string& prefix, const std::vector<std::string>& variables,
                              double time) {
  TextWriter writer(Empty{});
  constexpr const char* known[] = {"U", "F", "S", "E", "EKin", "EStrain"};
  for (const std::string& name : variables) {
    if (std::find(std::begin(known), std::end(known), name) == std::end(known))
      throw Error(ErrorKind::usage,
                  "'" + name + "' is no output variable. The variables are U, F, S, E, EKin and EStrain.");
    const auto same = [&](const auto& c) { return c->name == name; };
    if (std::any_of(writer.variables_.begin(), writer.variables_.end(), same)) continue;
    auto columns = std::make_unique<Columns>();
    columns->name = name;
    columns->text = prefix + name + ".txt";
    columns->binary = prefix + name + ".txt.columns";
    const bool fresh = time == -std::numeric_limits<double>::infinity();
    columns->open(fresh ? O_TRUNC : 0);
    if (!fresh) columns->cut_after(time);
    writer.variables_.push_back(std::move(columns));
  }
  std::int64_t common =
      std::numeric_limits<std::int64_t>::max();  // a killed run may have written only some of them
  for (const auto& columns : writer.variables_) common = std::min(common, columns->count);
  for (const auto& columns : writer.variables_) columns->keep(common);
  return writer;
}

int TextWriter::snapshot_count() const {
  return variables_.empty() ? 0 : static_cast<int>(variables_.front()->count);
}

void TextWriter::write(const Snapshot& snapshot, double kinetic, double strain) {
  std::vector<Field> fields{field("U", std::span(snapshot.displacement)),
                            field("F", std::span(snapshot.internal_force)),
                            field("EKin", std::span<const double>(&kinetic, 1)),
                            field("EStrain", std::span<const double>(&strain, 1))};
  for (Field& f : snapshot.element_fields()) {
    f.name = f.name == "stress" ? "S" : f.name == "strain" ? "E" : f.name;
    fields.push_back(std::move(f));
  }
  const auto of = [&](const std::string& name) -> const Field& {
    return *std::find_if(fields.begin(), fields.end(), [&](const Field& f) { return f.name == name; });
  };
  for (const auto& columns : variables_) {  // all are checked before the first is written
    const Field& f = of(columns->name);
    const std::size_t count = f.value_count() / static_cast<std::size_t>(f.components);
    const bool on_nodes = f.name == "U" || f.name == "F";
    const Fields one = on_nodes ? Fields{{f}, {}} : Fields{{}, {f}};
    require_finite(one, count, count, std::numeric_limits<double>::max());
  }
  for (const auto& columns : variables_) columns->append(snapshot.time, of(columns->name));
}

void TextWriter::finish(bool keep_columns) {
  for (const auto& columns : variables_) {
    write_atomically(columns->text, [&](std::ostream& out) { columns->write_rows(out); });
    if (keep_columns) continue;
    std::error_code ignored;
    std::filesystem::remove(columns->binary, ignored);
  }
}

}  // namespace glisson
