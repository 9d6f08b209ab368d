#include "core/asset/bake/FragmentLookup.h"

#include "tests/support/TestProgram.h"
#include "tests/support/asset/Projects.h"
#include "tests/support/asset/RandomAssets.h"

#include <QTest>

using namespace rubble;

class FragmentLookupTest : public QObject {
    Q_OBJECT
private slots:
    void everyFragmentIsFoundByItsPath() {
        Random random(4711);
        for (int kind = 0; kind < 30; ++kind) {
            Asset asset = test::randomAsset(random, kind).assets.front();
            asset.levels = {{.pattern = {{{.id = 90, .parameters = UniformScatter{.count = 3}}}}},
                            {.pattern = {{{.id = 91, .parameters = Slices{.cuts = 2}}}}, .minimumVolume = 0.01}};
            const Bake baked = *bake(asset);
            for (std::uint32_t k = 0; k < baked.fragmentCount(); ++k) {
                QCOMPARE(fragmentAt(baked, baked.fragmentPath(k)), std::optional(k));
            }
        }
    }
    void findsTheWholeAndNoMissingFragments() {
        const Bake baked = *bake(boxAsset(3, 5, PlacedSeeds{{{0, {0.2, 0.5}}, {1, {0.8, 0.5}}}}));
        QCOMPARE(fragmentAt(baked, {}), std::optional(kNone));
        for (const char* path : {"5.2", "5.0/5.0", "5.0.0", "nonsense", "5.1/", "/"}) {
            QVERIFY2(!fragmentAt(baked, path), path);
        }
    }
};

RUBBLE_TEST_WITH(FragmentLookupTest, QCoreApplication)
#include "FragmentLookupTest.moc"
