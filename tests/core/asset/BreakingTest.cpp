#include "core/asset/Breaking.h"

#include "core/fracture/Verify.h"
#include "tests/support/Projects.h"

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

Pattern scattered(SeedCount count) {
    return {{{.id = 5, .randomSeed = 7, .parameters = UniformScatter{.count = count}}}};
}

std::vector<std::string> idsOf(const std::string& parentId, const Breaking& breaking) {
    std::vector<std::string> ids;
    for (std::uint32_t k = 0; k < breaking.fragments.count(); ++k) {
        ids.push_back(fragmentId(parentId, breaking.seeds, breaking.fragments[k]));
    }
    return ids;
}

}  // namespace

class BreakingTest : public QObject {
    Q_OBJECT
private slots:
    void allStagesFitTogether() {
        const Result<Breaking> breaking = brokenBy({.pattern = scattered(50)}, {squareRing(), 0.5}, {});
        QVERIFY(breaking);
        QCOMPARE(breaking->seeds.positions.size(), std::size_t{50});
        QCOMPARE(verifyDelaunay(breaking->delaunay, breaking->seeds.positions).value_or(""), std::string());
        QCOMPARE(verifyPartition(breaking->fragments.partition, breaking->prism.outline).value_or(""), std::string());
        QCOMPARE(verifyFragments(breaking->fragments, breaking->prism).value_or(""), std::string());
    }
    void theOutlineMayRunEitherWay() {
        const Result<Breaking> breaking =
            brokenBy({.pattern = scattered(3)}, {{reversed(unitSquare().outer), {}}, 1.0}, {});
        QVERIFY(breaking);
        QVERIFY(signedArea(breaking->prism.outline.outer) > 0.0);
    }
    void fragmentsAreNamedAfterTheirSeeds() {
        const Result<Breaking> breaking =
            brokenBy({.pattern = placed({{0.25, 0.5}, {0.75, 0.5}})}, {unitSquare(), 1.0}, {});
        QCOMPARE(idsOf("3", *breaking), (std::vector<std::string>{"3/5.10", "3/5.11"}));
    }
    void piecesOfACutApartCellAreNumbered() {
        const Result<Breaking> breaking = brokenBy({.pattern = placed({{2, 2}, {0, 0}})}, {lShape(), 1.0}, {});
        QCOMPARE(idsOf("3/5.1", *breaking), (std::vector<std::string>{"3/5.1/5.10.0", "3/5.1/5.10.1", "3/5.1/5.11"}));
    }
    void withoutSeedsThereIsOneFragment() {
        const Result<Breaking> breaking = brokenBy({}, {unitSquare(), 1.0}, {});
        QCOMPARE(idsOf("3", *breaking), (std::vector<std::string>{"3/0.0"}));
    }
    void fragmentsDoNotBreakAlike() {
        const Pattern pattern = scattered(5);
        const Pattern first = patternFor("3/5.0", pattern), second = patternFor("3/5.1", pattern);
        QVERIFY(first.layers[0].randomSeed != second.layers[0].randomSeed);
        QVERIFY(first.layers[0].randomSeed != pattern.layers[0].randomSeed);
        QVERIFY(patternFor("3/5.0", pattern) == first);
    }
    void faultsOfEveryStageAreHandedOn() {
        const auto codeOf = [](const Pattern& pattern, Prism prism) {
            return brokenBy({.pattern = pattern}, std::move(prism), {}).error().code;
        };
        QCOMPARE(codeOf({}, {unitSquare(), 0.0}), ErrorCode::BadInput);
        QCOMPARE(codeOf({}, {{{{0, 0}, {1, 1}, {1, 0}, {0, 1}}, {}}, 1.0}), ErrorCode::Crossing);
        QCOMPARE(codeOf(scattered({CountBy::Density, kMostSeeds + 1.0}), {unitSquare(), 1.0}), ErrorCode::Limit);
        TaskContext task;
        task.cancel.cancel();
        QCOMPARE(brokenBy({.pattern = scattered(5)}, {unitSquare(), 1.0}, task).error().code, ErrorCode::Cancelled);
    }
};

QTEST_APPLESS_MAIN(BreakingTest)
#include "BreakingTest.moc"
