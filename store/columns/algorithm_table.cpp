#include "ar3d/store/columns/algorithm_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "ar3d/base/error.h"

namespace ar3d {
namespace {

constexpr std::array<const char*, 3> kAxes = {"_x", "_y", "_z"};
constexpr unsigned kLargestHalfPower = 18;  // of AxisBound

constexpr auto kInt = FieldType::int64;
constexpr auto kFloat = FieldType::float64;

Field text_field(const std::string& name, const char* meaning, std::size_t size) {
  Field field{name, "", meaning, FieldType::text, size};
  field.required = false;
  return field;
}

void add_bound(std::vector<Field>& fields, const std::string& whose) {
  fields.push_back(text_field(whose + "_name", "whose bound it is", 48));
  fields.push_back(text_field(whose + "_source", "where it is proved or stands", 96));
  fields.push_back(text_field(whose + "_formula", "the bound by axis, for people", 256));
  for (const char* axis : kAxes) {
    const std::string bound = "extent <= numerator / denominator * n^exponent + constant";
    const auto add = [&](const char* part, FieldType type) {
      fields.push_back({whose + part + axis, "1", bound, type, sizeof(double)});
    };
    add("_numerator", kInt);
    add("_denominator", kInt);
    add("_exponent", kFloat);
    add("_constant", kInt);
  }
}

TableSpec make_spec() {
  TableSpec spec{"algorithms", "what follows from algorithm and options", {}};
  spec.fields = {text_field("algorithm", "drawing algorithm", 48),
                 text_field("options", "its options, complete, in catalogue order", 96),
                 {"volume_order", "1", "exponent of n in the product of the theorem's bounds",
                  kFloat, sizeof(double)}};
  add_bound(spec.fields, "theorem");
  add_bound(spec.fields, "published");
  pack_fields(spec.fields);
  for (Field& field : spec.fields) field.required = false;
  return spec;
}

// A record of the table, whose fields are written or read one after the other.
class FieldCursor {
 public:
  explicit FieldCursor(char* record) : record_(record) {}

  void put(const std::string& text) {
    const Field& field = next();
    expect(text == fitted_text(text, field.size), "a text of /algorithms fits its column");
    text.copy(record_ + field.offset, text.size());
  }
  template <class Number>
  void put(Number value) {
    std::memcpy(record_ + next().offset, &value, sizeof(value));
  }
  void put_missing() {
    const Field& field = next();
    store_missing(field, record_ + field.offset);
  }

  std::string text() {
    const Field& field = next();
    const char* from = record_ + field.offset;
    return std::string(from, strnlen(from, field.size));
  }
  template <class Number>
  Number number() {
    Number value{};
    std::memcpy(&value, record_ + next().offset, sizeof(value));
    return value;
  }

 private:
  const Field& next() { return algorithms_spec().fields[place_++]; }

  char* record_;
  std::size_t place_ = 0;
};

constexpr std::size_t kFieldsOfBound = 3 + 3 * 4;

void put_bound(FieldCursor& to, const std::optional<SizeBound>& bound) {
  if (!bound) {
    for (std::size_t i = 0; i < kFieldsOfBound; ++i) to.put_missing();
    return;
  }
  to.put(bound->name);
  to.put(bound->source);
  to.put(bound->formula());
  for (const AxisBound& axis : bound->axes) {
    to.put(axis.numerator);
    to.put(axis.denominator);
    to.put(axis.half_power / 2.0);
    to.put(axis.constant);
  }
}

// Nothing if the bound is missing.
std::optional<SizeBound> take_bound(FieldCursor& from) {
  SizeBound bound;
  bound.name = from.text();
  bound.source = from.text();
  from.text();
  bool is_there = true;
  for (AxisBound& axis : bound.axes) {
    axis.numerator = from.number<std::int64_t>();
    axis.denominator = from.number<std::int64_t>();
    const double exponent = from.number<double>();
    axis.constant = from.number<std::int64_t>();
    is_there = is_there && !std::isnan(exponent);
    if (!is_there) continue;
    axis.half_power = static_cast<unsigned>(std::clamp(2 * exponent, 0.0, 100.0));
    if (axis.denominator < 1 || axis.half_power / 2.0 != exponent ||
        axis.half_power > kLargestHalfPower) {
      throw InputError(fmt::format("/algorithms: {}/{} n^{} + {} is no bound", axis.numerator,
                                   axis.denominator, exponent, axis.constant));
    }
  }
  if (!is_there) return std::nullopt;
  return bound;
}

}  // namespace

double AlgorithmRecord::volume_order() const {
  unsigned half_powers = 0;
  for (const AxisBound& axis : theorem.axes) half_powers += axis.half_power;
  return half_powers / 2.0;
}

const TableSpec& algorithms_spec() {
  static const TableSpec spec = make_spec();
  return spec;
}

StoredTable algorithm_table(const std::vector<AlgorithmRecord>& records) {
  StoredTable table{algorithms_spec(), {}};
  for (const AlgorithmRecord& record : records) {
    std::vector<char> bytes(record_size(table.spec.fields), '\0');
    FieldCursor to(bytes.data());
    to.put(record.algorithm);
    to.put(record.options);
    to.put(record.volume_order());
    put_bound(to, record.theorem);
    put_bound(to, record.published);
    table.records.insert(table.records.end(), bytes.begin(), bytes.end());
  }
  return table;
}

std::vector<AlgorithmRecord> algorithm_records(const StudyIdentity& identity) {
  std::vector<AlgorithmRecord> records;
  const StoredTable* table = find_table(identity, algorithms_spec().name);
  if (table == nullptr) return records;
  std::vector<char> bytes = table->records;
  for (std::size_t i = 0; i < table->size(); ++i) {
    FieldCursor from(bytes.data() + i * record_size(table->spec.fields));
    AlgorithmRecord record;
    record.algorithm = from.text();
    record.options = from.text();
    from.number<double>();  // follows from the bound
    const std::optional<SizeBound> theorem = take_bound(from);
    record.published = take_bound(from);
    if (!theorem) continue;
    record.theorem = *theorem;
    records.push_back(std::move(record));
  }
  return records;
}

const AlgorithmRecord* find_algorithm_record(const std::vector<AlgorithmRecord>& records,
                                             std::string_view algorithm, std::string_view options) {
  for (const AlgorithmRecord& record : records) {
    if (record.algorithm == algorithm && record.options == options) return &record;
  }
  return nullptr;
}

void set_bounds(const AlgorithmRecord* record, RunRecord& run) {
  const SizeBound* theorem = record == nullptr ? nullptr : &record->theorem;
  set_bounds(theorem, record != nullptr && record->published ? &*record->published : nullptr, run);
}

void set_bounds(const SizeBound* theorem, const SizeBound* published, RunRecord& run) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto value = [&](const SizeBound* bound) {
      if (bound == nullptr || run.n < 1) return kMissing;
      return bound->axes[axis].value(static_cast<std::uint64_t>(run.n));
    };
    const double proved = value(theorem);
    run.theorem_bound[axis] = proved > 0 ? proved : kMissing;
    run.published_bound[axis] = value(published);
    const bool has_slack = proved > 0 && run.extents[axis] >= 0;
    run.slack[axis] = has_slack ? 1 - static_cast<double>(run.extents[axis]) / proved : kMissing;
  }
}

}  // namespace ar3d
