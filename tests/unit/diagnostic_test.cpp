#include <gtest/gtest.h>

#include "lancer/base/diagnostic.h"

namespace lancer {
namespace {

TEST(Diagnostic, IsWrittenAsEditorsUnderstand) {
    EXPECT_EQ(to_string({Severity::error, {"a.toml", 3, 7}, "no"}), "a.toml:3:7: error: no");
    EXPECT_EQ(to_string({Severity::warning, {"a.toml", 3, 0}, "no"}), "a.toml:3: warning: no");
    EXPECT_EQ(to_string({Severity::note, {"a.toml", 0, 0}, "no"}), "a.toml: note: no");
    EXPECT_EQ(to_string({Severity::error, {}, "no"}), "error: no");
}

TEST(Diagnostics, OnlyErrorsCountAsErrors) {
    Diagnostics diagnostics;
    diagnostics.note({}, "a");
    diagnostics.warning({}, "b");
    EXPECT_FALSE(diagnostics.has_errors());
    diagnostics.error({}, "c");
    EXPECT_TRUE(diagnostics.has_errors());
    EXPECT_EQ(diagnostics.list().size(), 3u);
}

TEST(DidYouMean, FindsTheNearestWord) {
    const std::vector<std::string> words = {"radius", "center", "material", "N-BK7"};
    EXPECT_EQ(did_you_mean("radus", words), " did you mean \"radius\"?");
    EXPECT_EQ(did_you_mean("centre", words), " did you mean \"center\"?");
    EXPECT_EQ(did_you_mean("RADIUS", words), " did you mean \"radius\"?");
    EXPECT_EQ(did_you_mean("n-bk8", words), " did you mean \"N-BK7\"?");
    EXPECT_EQ(did_you_mean("colour", words), "");
    EXPECT_EQ(did_you_mean("", words), "");
    EXPECT_EQ(did_you_mean("x", {"y"}), "") << "a word with nothing in common is no advice";
}

}  // namespace
}  // namespace lancer
