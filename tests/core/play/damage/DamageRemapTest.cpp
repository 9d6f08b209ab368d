#include "core/play/damage/DamageRemap.h"

#include "tests/support/TestProgram.h"
#include "tests/support/play/Damages.h"

using namespace rubble;

class DamageRemapTest : public QObject {
    Q_OBJECT
private slots:
    void fragmentsKeepTheirDamageByTheirPaths() {
        Project project = test::threeBlocks();
        const auto before = test::playSceneOf(project);
        auto& scatter = std::get<UniformScatter>(project.assets[0].pattern.layers[0].parameters);
        scatter.count = 4u;  // the last seed is gone
        const auto after = test::playSceneOf(project);
        const PlayAsset &from = test::onlyAsset(*before), &to = test::onlyAsset(*after);

        InstanceDamage damage = intactDamage(before->project.assets[0], from);
        damage.broken = {true, true, false, false, false, true};
        const ContentHash bake = damageHash(project.assets[0], *to.bake);
        QVERIFY(damageFault(damage, bake, to).has_value());
        const Result<RemappedDamage> remapped = remappedDamage(damage, from, to, bake);
        QVERIFY(remapped.hasValue());
        QVERIFY(!damageFault(remapped->damage, bake, to));
        QCOMPARE(remapped->damage.broken, (std::vector<bool>{true, true, false, false, false}));
        QCOMPARE(remapped->dropped, std::vector<FragmentPath>{from.bake->fragmentPath(4)});
    }
    void whatIsOfNeitherAssetIsRefused() {
        const auto scene = test::playSceneOf(test::threeBlocks());
        const PlayAsset& asset = test::onlyAsset(*scene);
        InstanceDamage damage = intactDamage(scene->project.assets[0], asset);
        damage.broken.pop_back();
        QVERIFY(!remappedDamage(damage, asset, asset, damage.bake));
    }
};

RUBBLE_TEST(DamageRemapTest)
#include "DamageRemapTest.moc"
