// Tests core/asset/finish/FinishNoise.cpp, core/asset/finish/FinishParameters.cpp,
// core/asset/finish/FinishedSurface.cpp and core/asset/finish/AssetFinish.cpp.
#include "core/asset/finish/AssetFinish.h"
#include "core/asset/finish/FinishNoise.h"
#include "core/asset/finish/FinishedSurface.h"
#include "core/base/Hash.h"
#include "core/base/Random.h"
#include "core/fracture/kinds/BrickCourses.h"
#include "tests/support/TestProgram.h"
#include "tests/support/geometry/Outlines.h"

#include <QTest>

#include <cmath>
#include <map>

using namespace rubble;

namespace {

constexpr FinishSide kSides[] = {FinishSide::Outside, FinishSide::Inside};

Vec3 randomPoint(Random& random, double size) {
    return {random.between(-size, size), random.between(-size, size), random.between(-size, size)};
}

}  // namespace

class FinishTest : public QObject {
    Q_OBJECT
private slots:
    /// Pictures and baked textures must not depend on the machine.
    void noiseIsTheSameEverywhere() {
        std::uint64_t sum = 0, weighted = 0;
        for (const std::uint8_t byte : FinishNoise::shared().texels()) weighted += (sum += byte) % 65521;
        QCOMPARE(FinishNoise::shared().texels().size(), std::size_t{4} * 64 * 64 * 64);
        QCOMPARE(QString("%1 %2").arg(sum).arg(weighted), QString("134474920 34309868648"));
    }
    void noiseRepeatsAndIsContinuous() {
        Random random(1);
        for (int k = 0; k < 500; ++k) {
            const Vec3 place = randomPoint(random, 2.0), moved = place + Vec3(1.0, -2.0, 3.0);
            const Vec3 near = place + randomPoint(random, 1e-4);
            const auto here = FinishNoise::shared().at(place), there = FinishNoise::shared().at(moved),
                       beside = FinishNoise::shared().at(near);
            for (std::size_t channel = 0; channel < 4; ++channel) {
                QVERIFY(std::abs(here[channel] - there[channel]) < 1e-9);
                QVERIFY(std::abs(here[channel] - beside[channel]) < 0.03);
                QVERIFY(here[channel] >= 0.0 && here[channel] <= 1.0);
            }
        }
    }
    void noiseFillsItsRange() {
        for (std::size_t channel = 0; channel < 4; ++channel) {
            double sum = 0.0, squares = 0.0;
            const auto& texels = FinishNoise::shared().texels();
            for (std::size_t k = channel; k < texels.size(); k += 4) {
                sum += texels[k];
                squares += double{1.0} * texels[k] * texels[k];
            }
            const double count = static_cast<double>(texels.size() / 4), mean = sum / count;
            QVERIFY2(std::abs(mean - 127.5) < 20.0, qPrintable(QString::number(mean)));
            QVERIFY(std::sqrt(squares / count - mean * mean) > 25.0);
        }
    }
    /// A finish changes a colour, not its mean by much: what is white stays bright, what is dark stays dark.
    void meanColoursStay() {
        for (std::size_t finish = 0; finish < kFinishNames.size(); ++finish) {
            for (const FinishSide side : kSides) {
                const FinishParameters& parameters = finishParameters(static_cast<Finish>(finish), side);
                Random random(2);
                double sum = 0.0;
                constexpr int kPoints = 4000;
                for (int k = 0; k < kPoints; ++k) {
                    const FinishedSurface surface =
                        finishedSurface(parameters, randomPoint(random, 3.0), Vec3(0.0, 0.0, 1.0), Vec3(0.4));
                    sum += surface.albedo.y;
                    QVERIFY(surface.roughness >= 0.03 && surface.roughness <= 1.0);
                    QVERIFY(std::abs(surface.height) < 0.05);
                }
                const double mean = sum / kPoints;
                QVERIFY2(mean > 0.26 && mean < 0.52,
                         qPrintable(QString("%1 %2").arg(QLatin1StringView(kFinishNames[finish])).arg(mean)));
            }
        }
    }
    void plainSurfacesArePlain() {
        const FinishedSurface surface = finishedSurface(finishParameters(Finish::Plain, FinishSide::Outside),
                                                        Vec3(0.3, 0.1, 0.7), Vec3(0.0, 1.0, 0.0), Vec3(0.2));
        QCOMPARE(surface.albedo.x, 0.2);
        QCOMPARE(surface.height, 0.0);
    }
    /// In the middle of a joint there is mortar; bricks of one course differ, and a brick is the same everywhere.
    void bricksLieInCourses() {
        const FinishParameters& brick = finishParameters(Finish::Brick, FinishSide::Outside);
        const auto at = [&](double x, double y) {
            return finishedSurface(brick, Vec3(x, y, 0.0), Vec3(0.0, 0.0, 1.0), Vec3(0.3),
                                   {.courseOrigin = {0.02, 0.01}});
        };
        const double length = brick.courses.even[0], height = brick.courses.height;
        for (int row = -3; row <= 3; ++row) {
            const double middle = 0.01 + (row + 0.5) * height, shift = row % 2 == 0 ? 0.0 : 0.5 * length;
            QVERIFY(at(0.02 + shift, middle).height < -0.004);                 // between two bricks
            QVERIFY(at(0.02 + shift + 0.5 * length, middle).height > -0.002);  // on one
            QVERIFY(at(0.02 + 0.3 * length, 0.01 + row * height).height < -0.004);
        }
    }
    void coursesOfFragmentsReplaceThoseOfTheFinish() {
        const FinishParameters& brick = finishParameters(Finish::Brick, FinishSide::Outside);
        const BrickCourseFrame frame{.isOn = true, .form = {.height = 0.1f, .even = {0.3f, 0.3f}}};
        const FinishParameters cut = withCourses(brick, frame);
        QVERIFY(cut.courses == frame.form);
        QCOMPARE(cut.jointWidth, 0.0f);  // joints are geometry
        const FinishParameters wood = finishParameters(Finish::Wood, FinishSide::Outside);
        QCOMPARE(packedFinish(withCourses(wood, frame)), packedFinish(wood));
    }
    /// In every bond, each fragment has one tone, and those beside it have others.
    void everyBrickHasItsTone() {
        const Material material{.id = 1, .name = "brick", .finish = Finish::Brick};
        Random random(11);
        for (const BondKind bond :
             {BondKind::Stretcher, BondKind::Stack, BondKind::English, BondKind::Header, BondKind::Flemish}) {
            const BrickBond layer{.bond = bond, .mortar = 0.0, .origin = {0.13, -0.07}};
            Asset wall{.id = 2, .name = "wall", .material = 1};
            wall.shape = Prism{unitSquare(), 0.1};
            wall.pattern.layers = {{.id = 1, .parameters = layer}};
            SurfaceFinish finish = surfaceFinish(assetFinish(wall, material), FinishSide::Outside, Vec3(0.3));
            FinishParameters tonesOnly{.courseTone = 0.2f, .courses = finish.parameters.courses};
            finish.parameters = tonesOnly;
            const BrickCourses courses(layer);
            std::map<std::pair<int, int>, double> tones;
            for (int k = 0; k < 2000; ++k) {
                const Vec3 point = randomPoint(random, 1.5);
                const int course = courses.courseAt(point.y), column = courses.columnAt(course, point.x);
                const double tone = finish.at(point, {0.0, 0.0, 1.0}).albedo.x;
                QCOMPARE(tones.try_emplace({course, column}, tone).first->second, tone);
            }
            int alike = 0;
            for (const auto& [place, tone] : tones) {
                const auto next = tones.find({place.first, place.second + 1});
                alike += next != tones.end() && std::abs(next->second - tone) < 1e-4 ? 1 : 0;
            }
            QVERIFY2(alike < 5, qPrintable(QString::number(alike)));
        }
    }
    /// Courses of tiles are level and rise to the ridge, whichever way a roof was drawn.
    void tilesFollowTheRoof() {
        const Material material{.id = 1, .name = "tiles", .finish = Finish::Tiles};
        const double slope = 0.6;
        for (const bool isAlongX : {true, false}) {
            for (const bool isTurned : {true, false}) {
                Asset roof{.id = 2, .name = "roof", .material = 1};
                roof.shape = Prism{{rectangle({-1.0, -1.0}, {1.0, 1.0}), {}}, 0.2};
                const Quat lying = glm::angleAxis(-1.5707963267948966 + slope, Vec3(1.0, 0.0, 0.0));
                const double turn = (isAlongX ? 0.0 : 1.5707963267948966) + (isTurned ? 3.141592653589793 : 0.0);
                const Quat placed = lying * glm::angleAxis(turn, Vec3(0.0, 0.0, 1.0));
                const SurfaceFinish finish =
                    surfaceFinish(assetFinish(roof, material, placed), FinishSide::Outside, Vec3(0.3));
                QCOMPARE(std::abs(finish.frame.up), isAlongX ? 2 : 1);
                // Just above the lower edge of a course it stands out most.
                const auto heightAt = [&](double up) {
                    const Vec3 world = lying * Vec3(0.03, up, 0.1);
                    return finish.at(glm::inverse(placed) * world, {0.0, 0.0, 1.0}).height;
                };
                const double course = finish.parameters.courses.height;
                QVERIFY(heightAt((2.0 + 0.2) * course) > heightAt((2.0 + 0.9) * course) + 0.005);
            }
        }
    }
    /// Courses are level on a block that lies on its side, but follow the layer that cuts its bricks.
    void coursesAreLevel() {
        const Material material{.id = 1, .name = "brick", .finish = Finish::Brick};
        Asset block{.id = 2, .name = "block", .material = 1};
        block.shape = Prism{{rectangle({-0.5, -0.4}, {0.5, 0.4}), {}}, 0.6};
        const auto upIn = [&](const Quat& placed) { return assetFinish(block, material, placed).frame.up; };
        QCOMPARE(upIn(Quat(1.0, 0.0, 0.0, 0.0)), kUpright);
        QCOMPARE(upIn(Quat(0.5, 0.5, 0.5, 0.5)), 1);
        QCOMPARE(upIn(Quat(0.0, 1.0, 0.0, 0.0)), -kUpright);
        const double half = std::sqrt(0.5);
        QCOMPARE(upIn(Quat(half, half, 0.0, 0.0)), -3);
        QCOMPARE(upIn(Quat(half, 0.0, half, 0.0)), kUpright);
        block.pattern.layers = {{.id = 1, .parameters = BrickBond{}}};
        QCOMPARE(upIn(Quat(0.5, 0.5, 0.5, 0.5)), kUpright);
    }
    /// Bands and noise are turned with the grain, courses are not.
    void grainIsAlongTheLongestSide() {
        Material material{.id = 1, .name = "wood", .finish = Finish::Wood};
        Asset board{.id = 2, .name = "board", .material = 1};
        board.shape = Prism{{rectangle({-0.1, -1.5}, {0.1, 1.5}), {}}, 0.05};
        const AssetFinish finish = assetFinish(board, material);
        QCOMPARE(finish.frame.grainAxis, 1);
        QVERIFY(finish.outside == Finish::Wood && finish.inside == Finish::Wood);
        const Vec3 point(0.03, 1.1, 0.025), front(0.0, 0.0, 1.0);
        const FinishedSurface surface = surfaceFinish(finish, FinishSide::Outside, Vec3(0.4)).at(point, front);
        const FinishParameters& wood = finishParameters(Finish::Wood, FinishSide::Outside);
        const Vec3 turned(point.y, point.z, point.x);
        QCOMPARE(surface.albedo.x, finishedSurface(wood, turned, front, Vec3(0.4)).albedo.x);
        material.finish = Finish::Brick;
        const FinishParameters& brick = finishParameters(Finish::Brick, FinishSide::Outside);
        const Vec3 joint(0.03, 3.0 * brick.courses.height, 0.025);
        const double height =
            surfaceFinish(assetFinish(board, material), FinishSide::Outside, Vec3(0.4)).at(joint, front).height;
        QVERIFY(height < -0.004);
    }
    void imagesTakeThePlaceOfFinishesOutside() {
        const Material material{.id = 1, .name = "stone", .finish = Finish::Stone};
        Asset asset{.id = 2, .name = "block", .material = 1};
        asset.shape = Prism{unitSquare(), 0.5};
        asset.texture = Texture{};
        const AssetFinish finish = assetFinish(asset, material);
        QVERIFY(finish.outside == Finish::Plain && finish.inside == Finish::Stone && !finish.isPlain());
    }
};

RUBBLE_TEST(FinishTest)
#include "FinishTest.moc"
