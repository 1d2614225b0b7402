#include "sweep/expression/types.hpp"

#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "sigmasweep/base/errors.hpp"

namespace sigmasweep::expression_types {
namespace {

enum class Kind { number, truth, enumeration };

struct Type {
  Kind kind = Kind::number;
  FieldType enumeration{};  ///< of kind enumeration: its type
  bool operator==(const Type&) const = default;
};

Type type_of(FieldType field) { return enumerators(field).empty() ? Type{} : Type{Kind::enumeration, field}; }

class Checker {
 public:
  explicit Checker(const std::function<FieldType(const double*)>& type_of_variable) : variable_(type_of_variable) {}

  void apply(const mu::SToken& token) {
    switch (token.Cmd) {
      case mu::cmVAL: return push({});
      case mu::cmVAR: return push(type_of(variable_(token.Val.ptr)));
      case mu::cmLT:
      case mu::cmGT:
      case mu::cmLE:
      case mu::cmGE: return compare(false);
      case mu::cmEQ:
      case mu::cmNEQ: return compare(true);
      case mu::cmLAND: return combine("&&");
      case mu::cmLOR: return combine("||");
      case mu::cmADD:
      case mu::cmSUB:
      case mu::cmMUL:
      case mu::cmDIV:
      case mu::cmPOW: return calculate(2);
      case mu::cmFUNC: return call(token);
      case mu::cmIF: return require_truth("?");
      case mu::cmELSE: return;  // both values stay until cmENDIF
      case mu::cmENDIF: return choose();
      case mu::cmASSIGN: throw UsageError("'=' assigns; to compare write '=='");
      case mu::cmEND: return;
      default: throw UsageError("it has an operator that is not supported");
    }
  }

  void finish(Wanted wanted) {
    if (types_.size() != 1) throw UsageError("it is not one expression");
    const Kind kind = types_.back().kind;
    if (wanted == Wanted::truth && kind != Kind::truth) throw UsageError("it must be boolean, such as 'sigma > 1'");
    if (wanted == Wanted::number && kind != Kind::number)
      throw UsageError("it must be a number, such as '1 - eps_eff'");
  }

 private:
  void push(Type type) { types_.push_back(type); }

  Type pop() {
    if (types_.empty()) throw UsageError("it is not a complete expression");
    const Type type = types_.back();
    types_.pop_back();
    return type;
  }

  void require_truth(std::string_view what) {
    if (pop().kind != Kind::truth)
      throw UsageError(fmt::format("'{}' needs a boolean operand, such as '(sigma > 1)'", what));
  }

  void compare(bool equality) {
    const Type right = pop(), left = pop();
    const bool numbers = left.kind == Kind::number && right.kind == Kind::number;
    if (left.kind == Kind::truth && right.kind == Kind::number)
      throw UsageError("comparisons do not chain: write 'a < b && b < c'");
    if (left.kind == Kind::enumeration || right.kind == Kind::enumeration) {
      if (!equality) throw UsageError("names have no order: only '==' and '!=' compare them");
      if (left != right) throw UsageError("a name is compared with something that it can never be");
    } else if (!numbers && !(equality && left == right)) {
      throw UsageError("a comparison needs two numbers");
    }
    push({Kind::truth, {}});
  }

  void combine(std::string_view op) {
    require_truth(op);
    require_truth(op);
    push({Kind::truth, {}});
  }

  void calculate(int operands) {
    for (int i = 0; i < operands; ++i)
      if (pop().kind != Kind::number) throw UsageError("only numbers can be calculated with");
    push({});
  }

  void call(const mu::SToken& token) {
    if (token.Fun.cb == mu::generic_callable_type{reinterpret_cast<mu::erased_fun_type>(&logical_not), nullptr}) {
      require_truth("!");
      return push({Kind::truth, {}});
    }
    calculate(token.Fun.argc < 0 ? -token.Fun.argc : token.Fun.argc);  // negative: any number of arguments
  }

  void choose() {
    const Type other = pop(), one = pop();
    if (one != other) throw UsageError("both results of '?:' must be of the same type");
    push(one);
  }

  const std::function<FieldType(const double*)>& variable_;
  std::vector<Type> types_;
};

}  // namespace

double logical_not(double value) { return value == 0.0 ? 1.0 : 0.0; }

void require(Wanted wanted, const mu::ParserByteCode& code,
             const std::function<FieldType(const double*)>& type_of_variable) {
  Checker checker(type_of_variable);
  for (std::size_t i = 0; i < code.GetSize(); ++i) checker.apply(code.GetBase()[i]);
  checker.finish(wanted);
}

}  // namespace sigmasweep::expression_types
