#include "editor/commands/SelectedSeedEdits.h"

#include "editor/document/Translations.h"
#include "tests/support/TestProgram.h"
#include "tests/support/asset/Projects.h"

#include <QTest>

using namespace rubble;

namespace {

/// Three scattered seeds (layer 3), of which 0 is moved and 2 deleted, and two placed ones (layer 4).
Asset wallWithOverrides() {
    Asset asset = boxAsset(2, 3, UniformScatter{.count = 3});
    asset.pattern.layers[0].overrides = {{.index = 0, .position = {0.5, 0.5}}, {.index = 2, .isDeleted = true}};
    asset.pattern.layers.push_back({.id = 4, .parameters = PlacedSeeds{{{0, {0.2, 0.2}}, {1, {0.4, 0.2}}}}});
    return asset;
}

Asset editedAsset(const Edit& edit) { return *std::get<Replacement<Asset>>(edit.replacements.at(0)).value; }

}  // namespace

class SelectedSeedEditsTest : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() { installTranslations(); }
    void deletesPlacedAndScatteredSeeds() {
        const Edit edit = deleteSeeds(wallWithOverrides(), {}, {{3, 0}, {4, 0}});
        QVERIFY(edit.text.startsWith("Delete 2 Seed"));  // the plural is a translation
        const Pattern pattern = editedAsset(edit).pattern;
        QVERIFY(pattern.layers[0].overrides[0].isDeleted);
        QCOMPARE(std::get<PlacedSeeds>(pattern.layers[1].parameters).seeds.size(), std::size_t{1});
        QVERIFY(deleteSeeds(wallWithOverrides(), {}, {}).isEmpty());
    }
    void restoresTheGivenSeeds() {
        const Pattern pattern = editedAsset(restoreSeeds(wallWithOverrides(), {}, {{3, 0}})).pattern;
        QCOMPARE(pattern.layers[0].overrides.size(), std::size_t{1});
        QCOMPARE(pattern.layers[0].overrides[0].index, 2u);
    }
    void restoresAllWithoutASelection() {
        QVERIFY(editedAsset(restoreSeeds(wallWithOverrides(), {}, {})).pattern.layers[0].overrides.empty());
    }
    void nothingToRestoreIsAnEmptyEdit() {
        QVERIFY(restoreSeeds(wallWithOverrides(), {}, {{3, 1}, {4, 0}}).isEmpty());
        QVERIFY(restoreSeeds(boxAsset(2, 3, UniformScatter{}), {}, {}).isEmpty());
    }
    void cellsWithoutSeedsAreNoSeeds() {
        BakedPattern pattern;
        pattern.seeds.ids = {{3, 0}, {3, 1}};
        QVERIFY((seedsAmong(pattern, {{3, 1}, {8, 5}}) == FragmentSelection::Seeds{{3, 1}}));
    }
};

RUBBLE_TEST_WITH(SelectedSeedEditsTest, QCoreApplication)
#include "SelectedSeedEditsTest.moc"
