#include "sigmasweep/sweep/where.hpp"

#include <algorithm>
#include <array>
#include <deque>
#include <vector>

#include <fmt/format.h>
#include <muParser.h>

#include "sigmasweep/errors.hpp"
#include "sigmasweep/sweep/spelling.hpp"
#include "where_types.hpp"

namespace sigmasweep {
namespace {

constexpr std::array kinds_of_enumeration{FieldType::method, FieldType::wall, FieldType::integrator, FieldType::end,
                                          FieldType::status};

bool is_name(std::string_view token) {
  return !token.empty() && token.find_first_not_of("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ_0123456789") ==
                               std::string_view::npos && !(token[0] >= '0' && token[0] <= '9');
}

}  // namespace

struct Where::Impl {
  struct Variable {
    const Field* field;  ///< null for an enumerator
    FieldType type;
    double value;
  };

  mu::Parser parser;
  std::deque<Variable> variables;  ///< the parser and its byte code keep pointers to the values
  std::vector<Variable*> used;     ///< fields that the expression needs
  std::vector<std::string_view> names;

  void define(std::string_view name, const Variable& variable) {
    variables.push_back(variable);
    names.push_back(name);
    parser.DefineVar(std::string(name), &variables.back().value);
  }

  explicit Impl(std::span<const Field> fields) {
    parser.EnableOptimizer(false);  // byte code that follows the expression, for the types
    parser.DefineInfixOprt("!", expression_types::logical_not);
    for (const Field& field : fields) define(field.name, {&field, field.type, 0.0});
    for (const FieldType type : kinds_of_enumeration) {
      const auto owns = [&](const Field& field) { return field.type == type; };
      if (std::none_of(fields.begin(), fields.end(), owns)) continue;
      double number = 0.0;
      for (const auto name : enumerators(type)) define(name, {nullptr, type, number++});
    }
  }

  /// Notes that the variable kept at `value` is used; its type.
  FieldType use(const double* value) {
    const auto place = std::find_if(variables.begin(), variables.end(),
                                    [&](const Variable& variable) { return &variable.value == value; });
    if (place == variables.end()) throw UsageError("it has a name that is not known");
    if (place->field != nullptr && std::find(used.begin(), used.end(), &*place) == used.end()) used.push_back(&*place);
    return place->type;
  }

  void compile(const std::string& expression) {
    if (expression.size() > max_length)
      throw UsageError(fmt::format("an expression may have at most {} characters, this has {}", max_length,
                                   expression.size()));
    try {
      parser.SetExpr(expression);
      parser.Eval();
    } catch (const mu::ParserError& error) {
      throw UsageError(explain(error));
    }
    if (parser.GetNumResults() != 1) throw UsageError("it must be one expression, without ','");
    expression_types::require_boolean(parser.GetByteCode(), [this](const double* value) { return use(value); });
  }

  std::string explain(const mu::ParserError& error) const {
    const std::string& token = error.GetToken();
    if (token == "=") return "'=' assigns; to compare write '=='";
    if (token == "and" || token == "or" || token == "not") return "write && || ! for 'and', 'or', 'not'";
    if (error.GetCode() != mu::ecUNASSIGNABLE_TOKEN || !is_name(token)) return error.GetMsg();
    std::vector<std::string_view> functions;
    for (const auto& [name, function] : parser.GetFunDef()) functions.push_back(name);
    const bool means_function = !nearest(token, names) && nearest(token, functions);
    return fmt::format("unknown name '{}'{}", token, hint(token, means_function ? functions : names));
  }
};

Where::Where(const std::string& expression, std::span<const Field> fields) : impl_(std::make_unique<Impl>(fields)) {
  impl_->compile(expression);
}

Where::~Where() = default;
Where::Where(Where&&) noexcept = default;
Where& Where::operator=(Where&&) noexcept = default;

bool Where::operator()(const Row& row) {
  for (Impl::Variable* variable : impl_->used) variable->value = number(*variable->field, row);
  return impl_->parser.Eval() != 0.0;
}

}  // namespace sigmasweep
