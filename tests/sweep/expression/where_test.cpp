#include "sweep/expression/where.hpp"

#include <gtest/gtest.h>

#include "sigmasweep/base/errors.hpp"

using namespace sigmasweep;

namespace {

Row sample_row() {
  Row row;
  row.parameters.sigma = 2.0;
  row.parameters.N = 10;
  row.parameters.method = Method::ed;
  row.parameters.integrator = Integrator::gear5;
  row.result.status = Status::collapsed;
  row.result.eps_eff = 0.3;
  return row;
}

bool holds(const std::string& expression) { return Where(expression, parameter_fields())(sample_row()); }

std::string refusal(const std::string& expression) {
  try {
    Where(expression, parameter_fields());
  } catch (const UsageError& error) {
    return error.what();
  }
  return "accepted";
}

}  // namespace

TEST(Where, ComparesAndCombines) {
  EXPECT_TRUE(holds("sigma > 1"));
  EXPECT_FALSE(holds("sigma > 2"));
  EXPECT_TRUE(holds("sigma >= 2 && N == 10"));
  EXPECT_TRUE(holds("sigma < 1 || N != 9"));
  EXPECT_TRUE(holds("!(sigma < 1)"));
  EXPECT_FALSE(holds("!(sigma > 1 || N <= 3)"));
  EXPECT_TRUE(holds("N > 5 ? sigma > 1 : sigma > 3"));
  EXPECT_TRUE(holds("(sigma > 1) == (N > 1)"));
  EXPECT_TRUE(holds("abs(log10(sigma) - 0.30103) < 1e-5 && -N < 0"));
  EXPECT_TRUE(holds("max(sigma, N, 3) == 10"));
}

TEST(Where, AndBindsTighterThanOr) {
  EXPECT_TRUE(holds("N == 10 || N == 9 && sigma > 100"));
  EXPECT_FALSE(holds("(N == 10 || N == 9) && sigma > 100"));
}

TEST(Where, NamesOfEnumerations) {
  EXPECT_TRUE(holds("method == ed"));
  EXPECT_FALSE(holds("method == md"));
  EXPECT_TRUE(holds("md != method && integrator == gear5"));
  EXPECT_TRUE(holds("wall == paper"));
}

TEST(Where, NamesThatMeanSeveralThings) {
  Row row = sample_row();
  row.parameters.ed_rule = EdRule::tc;
  row.parameters.tc = 1e-4;
  row.parameters.law = Law::hertz_kuwabara_kono;
  row.parameters.random_separation = Flag::yes;
  row.result.end = End::separated;
  std::vector<Field> all(parameter_fields().begin(), parameter_fields().end());
  all.insert(all.end(), result_fields().begin(), result_fields().end());
  const auto is = [&](const std::string& expression) { return Where(expression, all)(row); };
  EXPECT_TRUE(is("ed_rule == tc && tc > 1e-5"));  // a value of ed_rule, and the contact time
  EXPECT_FALSE(is("ed_rule != tc || tc > 1"));
  EXPECT_TRUE(is("material == none && end != none"));  // of two enumerations
  EXPECT_TRUE(is("random_separation == true"));
  EXPECT_FALSE(is("random_separation == false"));
  EXPECT_TRUE(is("law == hertz-kuwabara-kono"));
  EXPECT_FALSE(is("law == hertz"));
  EXPECT_TRUE(is("law != power"));
  EXPECT_THROW(is("tc == lrv"), UsageError);
  EXPECT_THROW(is("law == steel"), UsageError);
}

TEST(Where, CanUseAnyFields) {
  std::vector<Field> all(parameter_fields().begin(), parameter_fields().end());
  all.insert(all.end(), result_fields().begin(), result_fields().end());
  EXPECT_TRUE(Where("status == collapsed && eps_eff < 0.5", all)(sample_row()));
  EXPECT_FALSE(Where("status == ok", all)(sample_row()));
  EXPECT_THROW(Where("status == md", all), UsageError);
}

TEST(Where, KeepsNothingFromTheRowBefore) {
  Where where("sigma > 1", parameter_fields());
  Row row = sample_row();
  EXPECT_TRUE(where(row));
  row.parameters.sigma = 0.5;
  EXPECT_FALSE(where(row));
  Where moved = std::move(where);
  row.parameters.sigma = 3.0;
  EXPECT_TRUE(moved(row));
}

TEST(Where, RefusesWhatIsNotBoolean) {
  for (const char* expression : {"sigma + 1", "sigma", "1", "0", "sigma * 0", "(sigma)", "method", "md", "sin(sigma)",
                                 "N > 1 ? 2 : 3", "min(sigma > 1, N > 1)", "-(sigma > 1)", "(sigma > 1) + 1"})
    EXPECT_NE(refusal(expression), "accepted") << expression;
  EXPECT_EQ(refusal("sigma + 1"), "it must be boolean, such as 'sigma > 1'");
}

TEST(Where, RefusesNumbersAsTruthValues) {
  EXPECT_EQ(refusal("sigma > 1 && N"), "'&&' needs a boolean operand, such as '(sigma > 1)'");
  EXPECT_EQ(refusal("sigma || N > 1"), "'||' needs a boolean operand, such as '(sigma > 1)'");
  EXPECT_EQ(refusal("!sigma > 1"), "'!' needs a boolean operand, such as '(sigma > 1)'");
  EXPECT_EQ(refusal("1 < sigma < 10"), "comparisons do not chain: write 'a < b && b < c'");
}

TEST(Where, RefusesComparingNamesWithAnythingElse) {
  EXPECT_EQ(refusal("method == paper"), "a name is compared with something that it can never be");
  EXPECT_EQ(refusal("method == 0"), "a name is compared with something that it can never be");
  EXPECT_EQ(refusal("method < ed"), "names have no order: only '==' and '!=' compare them");
  EXPECT_EQ(refusal("method + 1 > 0"), "only numbers can be calculated with");
}

TEST(Where, RefusesAssignmentListsAndUnknownNames) {
  EXPECT_EQ(refusal("sigma = 1"), "'=' assigns; to compare write '=='");
  EXPECT_EQ(refusal("N > 1 && sigma = 1"), "'=' assigns; to compare write '=='");
  EXPECT_EQ(refusal("sigma > 1 and N > 1"), "write && || ! for 'and', 'or', 'not'");
  EXPECT_EQ(refusal("sqr(sigma) > 1"), "unknown name 'sqr' (did you mean 'sqrt'?)");
  EXPECT_EQ(refusal("sigma > 1, N > 1"), "it must be one expression, without ','");
  EXPECT_EQ(refusal("sigm > 1"), "unknown name 'sigm' (did you mean 'sigma'?)");
  EXPECT_EQ(refusal("method == mdd"), "unknown name 'mdd' (did you mean 'md'?)");
  EXPECT_NE(refusal("xyzzy > 1").find("unknown name 'xyzzy'; known: v0, tc,"), std::string::npos);
  EXPECT_NE(refusal("eps_eff > 0.5").find("unknown name 'eps_eff'"), std::string::npos);  // no result here
  EXPECT_NE(refusal(""), "accepted");
  EXPECT_NE(refusal("sigma >"), "accepted");
  EXPECT_NE(refusal("(sigma > 1"), "accepted");
  EXPECT_NE(refusal("\"text\""), "accepted");
  EXPECT_EQ(refusal(std::string(2000, ' ') + "sigma > 1"),
            "an expression may have at most 1024 characters, this has 2009");
}
