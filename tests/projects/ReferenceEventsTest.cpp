// Events whose outcome people know, simulated with the presets of resources/materials and derived thresholds.
#include "core/asset/strength/Threshold.h"
#include "core/io/project/MaterialPresetFile.h"
#include "tests/support/TestProgram.h"
#include "tests/support/play/Sessions.h"

#include <QTest>

using namespace rubble;

namespace {

/// A ball that hits a plate, and whether the plate breaks.
struct Event {
    const char* name;
    const char* material;
    Vec3 size;  // m
    double mass;
    double speed;
    bool mustBreak;
};

const Event kEvents[] = {
    // A window: a boy's throw reaches 20 m/s, a leaning hand moves some 0.5 kg of arm at half a metre a second.
    {"a thrown stone shatters a window", "glass", {1.0, 1.0, 0.008}, 0.05, 20.0, true},
    {"a window stands a push by hand", "glass", {1.0, 1.0, 0.008}, 0.5, 0.5, false},
    // A wall one brick thick. A football of the laws of the game, 0.43 kg, is shot at 30 m/s by a good player; a
    // small car drives at 50 km/h.
    {"a brick wall takes a football", "brick", {3.0, 2.0, 0.24}, 0.43, 30.0, false},
    {"a car breaks a brick wall", "brick", {3.0, 2.0, 0.24}, 1200.0, 14.0, true},
    // A wall of 20 cm: one blow of a sledgehammer of 5 kg at 10 m/s chips it, a wrecking ball of a tonne opens it.
    {"concrete takes a sledgehammer", "concrete", {3.0, 2.5, 0.2}, 5.0, 10.0, false},
    {"a wrecking ball breaks concrete", "concrete", {3.0, 2.5, 0.2}, 1000.0, 5.0, true},
    // A trained hand, 0.7 kg at 10.6 m/s and more, breaks patio blocks of 4 cm; a ball of tennis, 58 g, does not.
    // Source: Wilk, McNair, Feld, "The physics of karate", American Journal of Physics 51, 1983, 783-790.
    {"a karate blow breaks a concrete block", "concrete", {0.4, 0.19, 0.04}, 0.7, 10.6, true},
    {"a concrete block takes a tossed ball", "concrete", {0.4, 0.19, 0.04}, 0.058, 10.0, false},
    // A worktop of 3 cm granite: a cup that is set down hard, 0.35 kg at 2 m/s; a blow of a sledgehammer.
    {"a worktop takes a cup", "stone", {2.0, 0.6, 0.03}, 0.35, 2.0, false},
    {"a sledgehammer breaks a worktop", "stone", {2.0, 0.6, 0.03}, 5.0, 10.0, true},
    // A door of solid wood, 4 cm: knuckles knock with half a kilogram at 2 m/s at most; an axe of 2.5 kg at 12 m/s
    // and the ram of the police, 16 kg at 6 m/s, break it.
    {"a door takes a knock", "wood", {0.9, 2.0, 0.04}, 0.5, 2.0, false},
    {"an axe breaks a door", "wood", {0.9, 2.0, 0.04}, 2.5, 12.0, true},
    {"a ram breaks a door", "wood", {0.9, 2.0, 0.04}, 16.0, 6.0, true},
    // A steel plate of 1 cm: a hammer of 0.5 kg at 10 m/s makes it ring; a lorry of 10 t at 14 m/s tears it.
    {"a steel plate takes a hammer", "metal", {1.0, 1.0, 0.01}, 0.5, 10.0, false},
    {"a lorry tears a steel plate", "metal", {1.0, 1.0, 0.01}, 10'000.0, 14.0, true},
    // A partition of gypsum blocks, 8 cm: a ball of tennis, served at 25 m/s; a sledgehammer.
    {"a partition takes a ball of tennis", "plaster", {2.5, 2.5, 0.08}, 0.058, 25.0, false},
    {"a sledgehammer breaks a partition", "plaster", {2.5, 2.5, 0.08}, 5.0, 8.0, true},
    // Ice of 10 cm, on which one may walk: a stone that is skipped over it; a boulder of 20 kg from 2 m.
    {"ice takes a skipped stone", "ice", {5.0, 5.0, 0.1}, 0.2, 15.0, false},
    {"a boulder breaks ice", "ice", {5.0, 5.0, 0.1}, 20.0, 6.3, true},
};

/// A plate of a material that stands upright and is held at its place, as a pane in its frame.
Project plateOf(const std::string& material, Vec3 size) {
    static const MaterialLibrary library = materialLibrary();
    Project project;
    project.gravity = Vec3(0.0);
    project.ground.isOn = false;
    const Id id = test::addMaterial(project, materialOf(findMaterial(library, material)->preset, 0));
    Asset plate{.name = "plate",
                .material = id,
                .shape = Prism{{rectangle({-size.x / 2.0, -size.y / 2.0}, {size.x / 2.0, size.y / 2.0}), {}}, size.z}};
    deriveThreshold(plate);
    const Id asset = test::addAsset(project, plate, {UniformScatter{.count = 12}});
    test::addInstance(project, asset, "plate", {});
    project.instances[0].isFixed = true;
    return project;
}

/// Whether a plate breaks when a ball hits its middle head on.
bool breaks(const Project& project, double mass, double speed) {
    Session session = test::sessionOf(project, {.dt = 1.0 / 240.0});
    const double radius = 0.05;
    const double front = project.assets[0].prism().depth / 2.0 + radius;
    test::addInput(session, ShotInput{"ball", Throw{.kind = ProjectileKind::Ball,
                                                    .size = Vec3(2.0 * radius),
                                                    .mass = mass,
                                                    .from = {0.0, 0.0, front + 0.1},
                                                    .to = {0.0, 0.0, front - 1.0},
                                                    .speed = speed}});
    const int steps = static_cast<int>(0.3 / speed * 240.0) + 10;
    return !test::breaksWithin(session, steps).empty();
}

}  // namespace

class ReferenceEventsTest : public QObject {
    Q_OBJECT
private slots:
    void platesBehaveAsTheyAreKnownTo_data() {
        QTest::addColumn<std::size_t>("event");
        for (std::size_t k = 0; k < std::size(kEvents); ++k) QTest::newRow(kEvents[k].name) << k;
    }
    void platesBehaveAsTheyAreKnownTo() {
        QFETCH(std::size_t, event);
        const Event& tried = kEvents[event];
        const Project project = plateOf(tried.material, tried.size);
        const double threshold = thresholdOf(project, project.assets[0]);
        QVERIFY2(breaks(project, tried.mass, tried.speed) == tried.mustBreak,
                 qPrintable(QString("%1 N·s").arg(threshold)));
    }
    void everyPresetBreaksInOneAndStandsAnother() {
        for (const LibraryMaterial& material : materialLibrary().materials) {
            const auto has = [&](bool mustBreak) {
                return std::ranges::any_of(kEvents, [&](const Event& event) {
                    return event.material == material.preset.name && event.mustBreak == mustBreak;
                });
            };
            QVERIFY2(has(true) && has(false), material.preset.name.c_str());
        }
    }
};

RUBBLE_TEST(ReferenceEventsTest)
#include "ReferenceEventsTest.moc"
