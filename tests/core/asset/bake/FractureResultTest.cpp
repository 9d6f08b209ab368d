#include "core/asset/bake/FractureResult.h"

#include "core/fracture/verify/VerifyDelaunay.h"
#include "core/fracture/verify/VerifyFragments.h"
#include "core/fracture/verify/VerifyPartition.h"
#include "tests/support/TestProgram.h"
#include "tests/support/asset/Projects.h"

#include <QTest>

using namespace rubble;

namespace {

Pattern placed(std::vector<Vec2> positions) {
    PlacedSeeds seeds;
    for (const Vec2 position : positions) {
        seeds.seeds.push_back({static_cast<std::uint32_t>(10 + seeds.seeds.size()), position});
    }
    return {{{.id = 5, .parameters = seeds}}};
}

Pattern scatteredPattern(SeedCount count) {
    return {{{.id = 5, .randomSeed = 7, .parameters = UniformScatter{.count = count}}}};
}

std::vector<std::string> idsOfFragments(const std::string& parentId, const FractureResult& fracture) {
    std::vector<std::string> ids;
    for (std::uint32_t k = 0; k < fracture.fragments.count(); ++k) {
        ids.push_back(fragmentId(parentId, fracture.seeds, fracture.fragments[k]));
    }
    return ids;
}

}  // namespace

class FractureResultTest : public QObject {
    Q_OBJECT
private slots:
    void allStagesAreConsistent() {
        const Result<FractureResult> fracture =
            fractureResult({.pattern = scatteredPattern(50)}, {squareRing(), 0.5}, {});
        QVERIFY(fracture);
        QCOMPARE(fracture->seeds.positions.size(), std::size_t{50});
        QCOMPARE(verifyDelaunay(fracture->delaunay, fracture->seeds.positions).value_or(""), std::string());
        QCOMPARE(verifyPartition(fracture->fragments.extruded()->partition, fracture->prism.outline).value_or(""),
                 std::string());
        QCOMPARE(verifyFragments(fracture->fragments, fracture->prism).value_or(""), std::string());
    }
    void outlineMayHaveEitherWinding() {
        const Result<FractureResult> fracture =
            fractureResult({.pattern = scatteredPattern(3)}, {{reversed(unitSquare().outer), {}}, 1.0}, {});
        QVERIFY(fracture);
        QVERIFY(signedArea(fracture->prism.outline.outer) > 0.0);
    }
    void fragmentsAreNamedAfterTheirSeeds() {
        const Result<FractureResult> fracture =
            fractureResult({.pattern = placed({{0.25, 0.5}, {0.75, 0.5}})}, {unitSquare(), 1.0}, {});
        QCOMPARE(idsOfFragments("3", *fracture), (std::vector<std::string>{"3/5.10", "3/5.11"}));
    }
    void partsOfACutApartCellAreNumbered() {
        const Result<FractureResult> fracture =
            fractureResult({.pattern = placed({{2, 2}, {0, 0}})}, {lShape(), 1.0}, {});
        QCOMPARE(idsOfFragments("3/5.1", *fracture),
                 (std::vector<std::string>{"3/5.1/5.10.0", "3/5.1/5.10.1", "3/5.1/5.11"}));
    }
    void withoutSeedsThereIsOneFragment() {
        const Result<FractureResult> fracture = fractureResult({}, {unitSquare(), 1.0}, {});
        QCOMPARE(idsOfFragments("3", *fracture), (std::vector<std::string>{"3/0.0"}));
    }
    void fragmentsFractureDifferently() {
        const Pattern pattern = scatteredPattern(5);
        const Pattern first = patternFor("3/5.0", pattern), second = patternFor("3/5.1", pattern);
        QVERIFY(first.layers[0].randomSeed != second.layers[0].randomSeed);
        QVERIFY(first.layers[0].randomSeed != pattern.layers[0].randomSeed);
        QVERIFY(patternFor("3/5.0", pattern) == first);
    }
    void errorsOfEveryStageAreReturned() {
        const auto codeOf = [](const Pattern& pattern, Prism prism) {
            return fractureResult({.pattern = pattern}, std::move(prism), {}).error().code;
        };
        QCOMPARE(codeOf({}, {unitSquare(), 0.0}), ErrorCode::BadInput);
        QCOMPARE(codeOf({}, {{{{0, 0}, {1, 1}, {1, 0}, {0, 1}}, {}}, 1.0}), ErrorCode::Crossing);
        QCOMPARE(codeOf(scatteredPattern({CountBy::Density, kMaxSeeds + 1.0}), {unitSquare(), 1.0}), ErrorCode::Limit);
        TaskContext task;
        task.cancel.cancel();
        QCOMPARE(fractureResult({.pattern = scatteredPattern(5)}, {unitSquare(), 1.0}, task).error().code,
                 ErrorCode::Cancelled);
    }
};

RUBBLE_TEST(FractureResultTest)
#include "FractureResultTest.moc"
