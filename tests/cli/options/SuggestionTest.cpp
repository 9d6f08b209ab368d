#include "app/cli/options/Suggestion.h"

#include "core/base/Random.h"
#include "tests/support/TestProgram.h"

#include <QTest>

#include <algorithm>
#include <array>

using namespace rubble;

namespace {

const std::vector<std::string> kWords{"new", "import", "export", "materials", "simulate", "--out", "--threads"};

std::string suggested(const std::string& typed) { return suggestionFor(typed, kWords).value_or("nothing"); }

}  // namespace

class SuggestionTest : public QObject {
    Q_OBJECT
private slots:
    void editsAreCounted() {
        QCOMPARE(editDistance("", ""), 0U);
        QCOMPARE(editDistance("export", "export"), 0U);
        QCOMPARE(editDistance("", "new"), 3U);
        QCOMPARE(editDistance("exprt", "export"), 1U);    // inserted
        QCOMPARE(editDistance("eexport", "export"), 1U);  // deleted
        QCOMPARE(editDistance("ezport", "export"), 1U);   // replaced
        QCOMPARE(editDistance("exoprt", "export"), 1U);   // exchanged
        QCOMPARE(editDistance("kitten", "sitting"), 3U);
        QCOMPARE(editDistance("ca", "abc"), 3U);  // no letter is edited twice
    }
    void distancesAreSymmetric() {
        constexpr std::uint64_t kSeed = 11;
        qInfo("seed %d", static_cast<int>(kSeed));
        Random random(kSeed);
        const auto word = [&random] {
            std::string text;
            for (std::uint64_t k = random.below(8); k > 0; --k) text += static_cast<char>('a' + random.below(3));
            return text;
        };
        for (int round = 0; round < 1000; ++round) {
            const std::string first = word(), second = word();
            const std::size_t distance = editDistance(first, second);
            QCOMPARE(editDistance(second, first), distance);
            QCOMPARE(distance == 0, first == second);
            QVERIFY(distance <= std::max(first.size(), second.size()));
        }
    }
    void nearestNameIsSuggested() {
        QCOMPARE(suggested("exprt"), "export");
        QCOMPARE(suggested("imprt"), "import");
        QCOMPARE(suggested("exmport"), "export");  // one edit away; import is two
        QCOMPARE(suggested("--outt"), "--out");
        QCOMPARE(suggested("--treads"), "--threads");
    }
    void onlyNameThatStartsSoIsSuggested() {
        QCOMPARE(suggested("mat"), "materials");
        QCOMPARE(suggested("--th"), "--threads");
        QCOMPARE(suggested("--"), "nothing");  // two start so
    }
    void otherWordsAreLeftAlone() {
        QCOMPARE(suggested("explode"), "nothing");
        QCOMPARE(suggested("zzz"), "nothing");
        QCOMPARE(suggested(""), "nothing");
        QVERIFY(!suggestionFor("new", {}));
    }
};

RUBBLE_TEST(SuggestionTest)
#include "SuggestionTest.moc"
