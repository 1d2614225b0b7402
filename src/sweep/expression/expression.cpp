#include "sweep/expression/expression.hpp"

#include <algorithm>
#include <cctype>
#include <set>

#include <fmt/format.h>

#include "base/spelling.hpp"
#include "sigmasweep/base/errors.hpp"

namespace sigmasweep {
namespace {

bool is_letter(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

bool is_name(std::string_view token) {
  return !token.empty() && std::all_of(token.begin(), token.end(), is_letter) && !(token[0] >= '0' && token[0] <= '9');
}

/// The variable that stands for enumerator `number` of a type; no name that users write.
std::string stand_in(FieldType type, std::size_t number) {
  return fmt::format("__{}_{}", static_cast<int>(type), number);
}

}  // namespace

Expression::Expression(const std::string& text, std::span<const Field> fields, expression_types::Wanted wanted)
    : fields_(fields.begin(), fields.end()) {
  if (text.size() > max_length)
    throw UsageError(fmt::format("an expression may have at most {} characters, this has {}", max_length, text.size()));
  parser_.EnableOptimizer(false);  // byte code that follows the expression, for the types
  parser_.DefineInfixOprt("!", expression_types::logical_not);
  for (const Field& field : fields_) define(field.name, {&field, field.type, 0.0});
  define_enumerators();
  try {
    parser_.SetExpr(resolved(text));
    parser_.Eval();
  } catch (const mu::ParserError& error) {
    throw UsageError(explain(error));
  }
  if (parser_.GetNumResults() != 1) throw UsageError("it must be one expression, without ','");
  expression_types::require(wanted, parser_.GetByteCode(), [this](const double* value) { return use(value); });
}

double Expression::operator()(const Row& row) {
  for (Variable* variable : used_) variable->value = number(*variable->field, row);
  return parser_.Eval();
}

std::vector<Field> Expression::used() const {
  std::vector<Field> fields;
  for (const Variable* variable : used_) fields.push_back(*variable->field);
  return fields;
}

void Expression::define(std::string_view name, const Variable& variable) {
  variables_.push_back(variable);
  parser_.DefineVar(std::string(name), &variables_.back().value);
  if (!name.starts_with("__")) names_.push_back(name);
}

/// Each under its stand-in; those whose name is a word that nothing else is called, also under that.
void Expression::define_enumerators() {
  std::set<FieldType> types;
  for (const Field& field : fields_)
    if (!enumerators(field.type).empty()) types.insert(field.type);
  for (const FieldType type : types) {
    std::size_t place = 0;
    for (const std::string_view name : enumerators(type)) {
      define(stand_in(type, place), {nullptr, type, static_cast<double>(place)});
      if (is_name(name) && std::find(names_.begin(), names_.end(), name) == names_.end())
        define(name, {nullptr, type, static_cast<double>(place)});
      ++place;
    }
  }
}

/// The text with `field == enumerator` made unambiguous: names may be those of fields too (ed_rule == tc), of several
/// enumerations (none), or no words (hertz-kuwabara-kono).
std::string Expression::resolved(const std::string& text) const {
  std::string out;
  std::size_t i = 0;
  const auto copy_while = [&](auto belongs) {
    const std::size_t begin = i;
    while (i < text.size() && belongs(text[i])) ++i;
    out.append(text, begin, i - begin);
    return std::string_view(text).substr(begin, i - begin);
  };
  const auto is_space = [](char c) { return std::isspace(static_cast<unsigned char>(c)) != 0; };
  while (i < text.size()) {
    const std::string_view word = copy_while(is_letter);
    if (word.empty()) {
      out += text[i++];
      continue;
    }
    const auto field = std::find_if(fields_.begin(), fields_.end(), [&](const Field& f) { return f.name == word; });
    if (field == fields_.end() || enumerators(field->type).empty()) continue;
    copy_while(is_space);
    if (text.compare(i, 2, "==") != 0 && text.compare(i, 2, "!=") != 0) continue;
    out.append(text, i, 2);
    i += 2;
    copy_while(is_space);
    const auto names = enumerators(field->type);
    std::size_t best = names.size();
    for (std::size_t k = 0; k < names.size(); ++k) {
      const std::size_t end = i + names[k].size();
      if (text.compare(i, names[k].size(), names[k]) == 0 && (end >= text.size() || !is_letter(text[end])) &&
          (best == names.size() || names[k].size() > names[best].size()))
        best = k;
    }
    if (best == names.size()) continue;
    out += stand_in(field->type, best);
    i += names[best].size();
  }
  return out;
}

/// Notes that the variable kept at `value` is used; its type.
FieldType Expression::use(const double* value) {
  const auto place = std::find_if(variables_.begin(), variables_.end(),
                                  [&](const Variable& variable) { return &variable.value == value; });
  if (place == variables_.end()) throw UsageError("it has a name that is not known");
  if (place->field != nullptr && std::find(used_.begin(), used_.end(), &*place) == used_.end())
    used_.push_back(&*place);
  return place->type;
}

std::string Expression::explain(const mu::ParserError& error) const {
  const std::string& token = error.GetToken();
  if (token == "=") return "'=' assigns; to compare write '=='";
  if (token == "and" || token == "or" || token == "not") return "write && || ! for 'and', 'or', 'not'";
  if (error.GetCode() != mu::ecUNASSIGNABLE_TOKEN || !is_name(token)) return error.GetMsg();
  std::vector<std::string_view> functions;
  for (const auto& [name, function] : parser_.GetFunDef()) functions.push_back(name);
  const bool means_function = !nearest(token, names_) && nearest(token, functions);
  return fmt::format("unknown name '{}'{}", token, hint(token, means_function ? functions : names_));
}

}  // namespace sigmasweep
