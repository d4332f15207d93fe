// The table of common materials (resources/materials.toml, built in): cutting force coefficients, process damping and
// their spread by name, each with its source. For first lobes; measured coefficients are better.
// Thread: any.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/milling/cut_model.h"

namespace stillcut::milling {

struct TableMaterial {
  std::string name;
  std::vector<std::string> also;  // other names of it
  std::string what;               // in words, with the hardness or strength the values are for
  Material material;
  std::string source;  // where the force coefficients were published
  std::string remark;  // which of its entries, and how what is not published was set
};

// In the order of the file. A table that cannot be read is a fault of this build: then empty, and a test fails.
const std::vector<TableMaterial>& materialTable();

// By its name or another one, capitals, blanks and hyphens aside. Null: none.
const TableMaterial* findMaterial(std::string_view name);
// The same with one clear line, which says what comes nearest.
Result<Material> materialNamed(std::string_view name, const std::string& where);

// Exposed for tests: the table of a text.
Result<std::vector<TableMaterial>> readMaterialTable(std::string_view content, const std::string& where);

}  // namespace stillcut::milling
