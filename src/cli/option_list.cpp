#include "cli/option_list.hpp"

#include <sstream>

namespace sigmasweep {
namespace {

/// Keeps what a command adds, and reads nothing.
class OptionList final : public OptionSet {
 public:
  explicit OptionList(std::vector<ListedOption>& listed) : listed_(listed) {}
  void add(const Option& option, std::string&) override { keep(option); }
  void add(const Option& option, std::vector<std::string>&, Several) override { keep(option); }
  void add(const Option& option, int&, Limits) override { keep(option); }
  void add(const Option& option, std::optional<std::uint64_t>&, Limits) override { keep(option); }
  void add(const Option& option, std::function<bool(const std::string&)>) override { keep(option); }
  void add_flag(const std::string& names, const std::string& meaning, bool&, bool) override {
    keep({.names = names, .meaning = meaning, .type_name = {}}, false);
  }

 private:
  void keep(const Option& option, bool has_value = true) {
    if (option.hidden) return;
    ListedOption& listed = listed_.emplace_back();
    std::istringstream names(option.names);
    for (std::string name; std::getline(names, name, ',');) listed.names.push_back(name);
    listed.meaning = option.meaning;
    listed.type_name = option.type_name;
    listed.choices = option.choices;
    listed.has_value = has_value;
  }

  std::vector<ListedOption>& listed_;
};

}  // namespace

std::vector<ListedOption> options_of(const Command& command) {
  std::vector<ListedOption> listed;
  OptionList list(listed);
  command.prepare(list);
  listed.push_back({{"-h", "--help"}, "Print this help message and exit", "", {}, false});
  return listed;
}

}  // namespace sigmasweep
