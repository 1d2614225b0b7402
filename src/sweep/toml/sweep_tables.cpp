#include "sweep/toml/sweep_tables.hpp"

#include <string_view>

namespace sigmasweep::spec {

std::vector<const toml::table*> sweep_tables(const toml::table& spec) {
  std::vector<const toml::table*> tables;
  for (const std::string_view name : {"defaults", "sweep"}) {
    if (const toml::table* table = spec[name].as_table()) tables.push_back(table);
    if (const toml::array* several = spec[name].as_array())
      for (const toml::node& node : *several)
        if (node.is_table()) tables.push_back(node.as_table());
  }
  return tables;
}

}  // namespace sigmasweep::spec
