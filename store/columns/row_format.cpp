#include "ar3d/store/columns/row_format.h"

namespace ar3d {

RowKey key_of_record(const RowFormat& format, const char* record) {
  const Field& field = format.rows.fields[format.key];
  return parse_row_key({record + field.offset, field.size});
}

}  // namespace ar3d
