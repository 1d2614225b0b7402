#include "sweep/expression/expression.hpp"

#include <algorithm>
#include <cctype>

#include <fmt/format.h>

#include "base/spelling.hpp"
#include "sigmasweep/base/errors.hpp"

namespace sigmasweep {
namespace {

bool is_letter(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

bool is_name(std::string_view token) {
  return !token.empty() && std::all_of(token.begin(), token.end(), is_letter) && !(token[0] >= '0' && token[0] <= '9');
}

}  // namespace

template <class Owner>
Expression<Owner>::Expression(const std::string& text, std::span<const FieldOf<Owner>> fields,
                              expression_types::Wanted wanted)
    : fields_(fields.begin(), fields.end()) {
  if (text.size() > max_length)
    throw UsageError(fmt::format("an expression may have at most {} characters, this has {}", max_length, text.size()));
  parser_.EnableOptimizer(false);  // the check of types needs byte code that follows the expression
  parser_.DefineInfixOprt("!", expression_types::logical_not);
  for (const FieldOf<Owner>& field : fields_) define(field.name, {&field, field.type, 0.0});
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

template <class Owner>
double Expression<Owner>::operator()(const Owner& owner) {
  for (Variable* variable : used_) variable->value = number(*variable->field, owner);
  return parser_.Eval();
}

template <class Owner>
std::vector<FieldOf<Owner>> Expression<Owner>::used() const {
  std::vector<FieldOf<Owner>> fields;
  for (const Variable* variable : used_) fields.push_back(*variable->field);
  return fields;
}

template <class Owner>
void Expression<Owner>::define(std::string_view name, const Variable& variable) {
  variables_.push_back(variable);
  parser_.DefineVar(std::string(name), &variables_.back().value);
  if (!name.starts_with("__")) names_.push_back(name);
}

/// The name of the variable for an enumerator, which users do not write.
template <class Owner>
std::string Expression<Owner>::stand_in(const FieldType& enumeration, std::size_t number) const {
  const auto place = std::ranges::find(enumerations_, enumeration) - enumerations_.begin();
  return fmt::format("__{}_{}", place, number);
}

/// Defines a variable for each enumerator, under its stand-in. If its name is a word that is not defined yet, the
/// enumerator is also defined under its name.
template <class Owner>
void Expression<Owner>::define_enumerators() {
  for (const FieldOf<Owner>& field : fields_)
    if (!enumerators(field.type).empty() && std::ranges::find(enumerations_, field.type) == enumerations_.end())
      enumerations_.push_back(field.type);
  for (const FieldType& type : enumerations_) {
    std::size_t place = 0;
    for (const std::string_view name : enumerators(type)) {
      define(stand_in(type, place), {nullptr, type, static_cast<double>(place)});
      if (is_name(name) && std::find(names_.begin(), names_.end(), name) == names_.end())
        define(name, {nullptr, type, static_cast<double>(place)});
      ++place;
    }
  }
}

/// The text with the stand-in of each enumerator that is compared with a field. The name alone may be a field's, too
/// (ed_rule == tc), belong to several enumerations (none), or not be a word (hertz-kuwabara-kono).
template <class Owner>
std::string Expression<Owner>::resolved(const std::string& text) const {
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
    const auto field =
        std::find_if(fields_.begin(), fields_.end(), [&](const FieldOf<Owner>& f) { return f.name == word; });
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

/// Marks the variable whose value is at `value` as used and returns its type.
template <class Owner>
FieldType Expression<Owner>::use(const double* value) {
  const auto place = std::find_if(variables_.begin(), variables_.end(),
                                  [&](const Variable& variable) { return &variable.value == value; });
  if (place == variables_.end()) throw UsageError("it has a name that is not known");
  if (place->field != nullptr && std::find(used_.begin(), used_.end(), &*place) == used_.end())
    used_.push_back(&*place);
  return place->type;
}

template <class Owner>
std::string Expression<Owner>::explain(const mu::ParserError& error) const {
  const std::string& token = error.GetToken();
  if (token == "=") return "'=' assigns; to compare write '=='";
  if (token == "and" || token == "or" || token == "not") return "write && || ! for 'and', 'or', 'not'";
  if (error.GetCode() != mu::ecUNASSIGNABLE_TOKEN || !is_name(token)) return error.GetMsg();
  std::vector<std::string_view> functions;
  for (const auto& [name, function] : parser_.GetFunDef()) functions.push_back(name);
  const bool means_function = !nearest(token, names_) && nearest(token, functions);
  return fmt::format("unknown name '{}'{}", token, hint(token, means_function ? functions : names_));
}

template class Expression<Row>;
template class Expression<Parameters>;
template class Expression<double>;

}  // namespace sigmasweep
