#include "core/base/Trigonometry.h"
#include "tests/support/Outlines.h"
#include "tests/support/PatternSamples.h"
#include "tests/support/VerifiedPartition.h"

#include <QTest>

#include <algorithm>
#include <limits>
#include <numbers>
#include <set>

using namespace rubble;

namespace {

constexpr std::uint64_t kRandomSeeds = 1000;

/// A ring around the origin of so many corners, between two distances from it.
Ring ringAround(int corners, double least, double most, Random& random) {
    Ring ring;
    for (int k = 0; k < corners; ++k) {
        const double angle = 2.0 * std::numbers::pi * k / corners, radius = random.between(least, most);
        ring.push_back(radius * Vec2(cosine(angle), sine(angle)));
    }
    return ring;
}

/// Convex, concave, and concave with a hole, in turns.
Polygon randomOutline(std::uint64_t randomSeed) {
    Random random(randomSeed);
    const int corners = 3 + static_cast<int>(random.below(9));
    switch (randomSeed % 3) {
        case 0: return {ringAround(corners, 1.0, 1.0, random), {}};
        case 1: return {ringAround(corners + 3, 0.3, 1.2, random), {}};
        default: return {ringAround(corners + 3, 0.7, 1.2, random), {reversed(ringAround(corners, 0.1, 0.3, random))}};
    }
}

Pattern patternOf(const LayerParameters& parameters, std::uint64_t randomSeed) {
    return {{{.id = 1, .randomSeed = randomSeed, .parameters = UniformScatter{.count = 2}},
             {.id = 2, .randomSeed = randomSeed, .parameters = parameters}}};
}

/// What is wrong with the seeds of a layer on an outline, or nothing.
QString faultOn(const Polygon& outline, const Pattern& pattern) {
    const Result<Seeds> seeds = seedsOf(pattern, outline);
    if (!seeds) return QString::fromStdString(seeds.error().message);
    if (!std::ranges::is_sorted(seeds->ids)) return "The seeds are not in the order of their ids.";
    if (std::ranges::adjacent_find(seeds->ids) != seeds->ids.end()) return "Two seeds have one id.";
    if (seeds->positions != seedsOf(pattern, outline)->positions) return "The same recipe gives other seeds.";
    const Result<Partition> partition = verifiedPartition(outline, seeds->positions);
    if (!partition) return QString::fromStdString(partition.error().message);
    double sum = 0.0;
    for (std::uint32_t piece = 0; piece < partition->pieceCount(); ++piece) sum += pieceArea(*partition, piece);
    return std::abs(sum - area(outline)) <= 1e-9 * area(outline) ? QString() : "Area is lost.";
}

std::string faultOfLayer(const LayerParameters& parameters) {
    return verifyPattern({{{.id = 4, .parameters = parameters}}}).value_or("");
}

}  // namespace

class PatternKindsTest : public QObject {
    Q_OBJECT
private slots:
    void everyKindIsTried() {
        std::set<std::size_t> tried;
        for (const LayerParameters& sample : patternSamples()) tried.insert(sample.index());
        QCOMPARE(tried.size(), patternKinds().size());
    }
    void everyKindBreaksAThousandOutlines() {
        qInfo("random seeds 0 to %d", static_cast<int>(kRandomSeeds) - 1);
        const std::vector<LayerParameters> samples = patternSamples();
        for (std::uint64_t randomSeed = 0; randomSeed < kRandomSeeds; ++randomSeed) {
            const Polygon outline = randomOutline(randomSeed);
            for (std::size_t k = 0; k < samples.size(); ++k) {
                const QString fault = faultOn(outline, patternOf(samples[k], randomSeed));
                QVERIFY2(fault.isEmpty(), qPrintable(QString("random seed %1, sample %2 (%3): %4")
                                                         .arg(randomSeed)
                                                         .arg(k)
                                                         .arg(kindOf(samples[k]).caption, fault)));
            }
        }
    }
    void whatLeavesTheOutlineIsLeftOutOrWanted() {
        for (const LayerParameters& sample : patternSamples()) {
            const auto* grid = std::get_if<JitteredGrid>(&sample);
            const auto* uniform = std::get_if<UniformScatter>(&sample);
            const bool mayLeave = kindOf(sample).role != LayerRole::Scatters ||
                                  (grid && grid->domain == ScatterDomain::BoundingBox) ||
                                  (uniform && uniform->domain == ScatterDomain::BoundingBox);
            for (std::uint64_t randomSeed = 0; randomSeed < 30 && !mayLeave; ++randomSeed) {
                const Polygon outline = randomOutline(randomSeed);
                const Seeds seeds = seedsOf(patternOf(sample, randomSeed), outline).value();
                for (const Vec2 seed : seeds.positions) {
                    QVERIFY2(containment(outline, seed) != Containment::Outside, kindOf(sample).caption);
                }
            }
        }
    }
    void newLayersSuitWhatTheyFill() {
        for (const Polygon& outline : {unitSquare(), Polygon{rectangle({-1e-3, 0.0}, {1e-3, 5e-4}), {}},
                                       Polygon{rectangle({100.0, 50.0}, {400.0, 51.0}), {}}}) {
            for (const PatternKind* kind : patternKinds()) {
                const LayerParameters parameters = kind->suitedTo(boundsOf(outline.outer));
                QVERIFY(&kindOf(parameters) == kind);
                QCOMPARE(faultOfLayer(parameters), std::string());
                const Result<Seeds> seeds = seedsOf({{{.id = 1, .randomSeed = 1, .parameters = parameters}}}, outline);
                QVERIFY2(seeds, kind->caption);
                const bool isEmpty =
                    kind->role != LayerRole::Scatters || std::holds_alternative<DensityImage>(parameters);
                QVERIFY2(isEmpty == seeds->positions.empty(), kind->caption);
                QVERIFY2(seeds->positions.size() < 300, kind->caption);
            }
        }
    }
    void cancelledLayersStop() {
        TaskContext task;
        task.cancel.cancel();
        for (const LayerParameters& sample : patternSamples()) {
            const auto* image = std::get_if<DensityImage>(&sample);
            if (std::holds_alternative<PlacedSeeds>(sample) || (image && !image->image)) continue;
            const PatternLayer layer{.id = 1, .parameters = sample};
            const Polygon outline = unitSquare();
            SeedSet seeds;
            seeds.add({0, 0}, {0.5, 0.5}, false);
            const Status applied = std::visit(
                [&](const auto& parameters) {
                    return parameters.apply({layer, outline, task}, seeds);
                },
                sample);
            QVERIFY2(!applied && applied.error().code == ErrorCode::Cancelled, kindOf(sample).caption);
        }
    }
    void everyParameterIsHeldToItsRange() {
        for (const LayerParameters& sample : patternSamples()) {
            QCOMPARE(faultOfLayer(sample), std::string());
            for (const LayerParameter& parameter : kindOf(sample).parameters) {
                const bool isReal = parameter.type == ParameterType::Real;
                const double infinity = std::numeric_limits<double>::infinity();
                for (const double value : {parameter.range.min - 1.0, parameter.range.max + 1.0, infinity, -infinity,
                                           std::numeric_limits<double>::quiet_NaN()}) {
                    LayerParameters changed = sample;
                    if (!isReal || parameter.range.contains(value)) continue;
                    parameter.write(changed, value);
                    const std::string fault = faultOfLayer(changed);
                    QVERIFY2(fault.starts_with("Layer 4: \"" + std::string(parameter.caption)), fault.c_str());
                }
            }
        }
    }
    void parametersAreReadAsTheyAreWritten() {
        for (const LayerParameters& sample : patternSamples()) {
            const PatternKind& kind = kindOf(sample);
            LayerParameters copy = kind.suitedTo({{0.0, 0.0}, {3.0, 2.0}});
            for (const LayerParameter& parameter : kind.parameters) parameter.write(copy, parameter.read(sample));
            if (auto* placed = std::get_if<PlacedSeeds>(&copy)) *placed = std::get<PlacedSeeds>(sample);
            if (auto* density = std::get_if<DensityImage>(&copy)) density->image = std::get<DensityImage>(sample).image;
            QVERIFY2(copy == sample, kind.caption);
        }
    }
    void namesAndCaptionsAreNotEmptyAndUnique() {
        std::set<std::string_view> names;
        for (const PatternKind* kind : patternKinds()) {
            QVERIFY(names.insert(kind->name).second);
            QVERIFY(*kind->caption && *kind->hint);
            std::set<std::string_view> ofKind;
            for (const LayerParameter& parameter : kind->parameters) {
                QVERIFY(ofKind.insert(parameter.name).second && *parameter.caption && *parameter.hint);
                QCOMPARE(parameter.type == ParameterType::Choice, !parameter.choices.empty());
            }
        }
    }
};

QTEST_APPLESS_MAIN(PatternKindsTest)
#include "PatternKindsTest.moc"
