// Tests core/asset/project/Ranges.cpp in play: projects with numbers in their ranges can be played, others are refused.
#include "core/asset/checks/VerifyProject.h"
#include "core/asset/project/Ranges.h"
#include "core/base/Random.h"
#include "core/physics/world/BodyScene.h"
#include "tests/support/TestProgram.h"
#include "tests/support/asset/Simulated.h"
#include "tests/support/play/Sessions.h"

#include <functional>
#include <limits>
#include <set>

using namespace rubble;

namespace {

/// A number of a project, and how to set it.
struct Setter {
    ProjectNumber number;
    std::function<void(Project&, double)> set;
};

Material& material(Project& p) { return p.materials[0]; }
Asset& asset(Project& p) { return p.assets[0]; }
template <class Action>
Action& action(Project& p) {
    for (Shot& shot : p.shots) {
        if (Action* found = std::get_if<Action>(&shot.action)) return *found;
    }
    qFatal("There is no such shot.");
}

const std::vector<Setter>& setters() {
    using N = ProjectNumber;
    static const std::vector<Setter> all{
        {N::Density, [](Project& p, double v) { material(p).density = v; }},
        {N::Friction, [](Project& p, double v) { material(p).friction = v; }},
        {N::Friction, [](Project& p, double v) { p.ground.friction = v; }},
        {N::Restitution, [](Project& p, double v) { material(p).restitution = v; }},
        {N::TensileStrength, [](Project& p, double v) { material(p).tensileStrength = v; }},
        {N::FractureToughness, [](Project& p, double v) { material(p).fractureToughness = v; }},
        {N::YoungsModulus, [](Project& p, double v) { material(p).youngsModulus = v; }},
        {N::ColourChannel, [](Project& p, double v) { material(p).inside.blue = v; }},
        {N::PrismDepth, [](Project& p, double v) { asset(p).prism().depth = v; }},
        {N::OutlineSize,
         [](Project& p, double v) {
             for (Vec2& corner : asset(p).prism().outline.outer) corner.x = corner.x > 0.0 ? v : 0.0;
         }},
        {N::OutlineCoordinate,
         [](Project& p, double v) {
             const double other = v - std::copysign(1.0, v);
             for (Vec2& corner : asset(p).prism().outline.outer) corner.y = corner.y > 0.0 ? v : other;
         }},
        {N::Gap, [](Project& p, double v) { asset(p).shaping.gap = v; }},
        {N::RoughnessAmplitude, [](Project& p, double v) { asset(p).shaping.roughness.amplitude = v; }},
        {N::RoughnessFrequency, [](Project& p, double v) { asset(p).shaping.roughness.frequency = v; }},
        {N::Threshold, [](Project& p, double v) { asset(p).threshold = v; }},
        {N::Threshold, [](Project& p, double v) { p.instances[0].threshold = v; }},
        {N::InsideUvScale, [](Project& p, double v) { asset(p).insideUvScale = v; }},
        {N::ImpactFalloffRadius,
         [](Project& p, double v) { asset(p).cutAtImpact = CutAtImpact{.fragments = 3, .falloffRadius = v}; }},
        {N::InstancePosition, [](Project& p, double v) { p.instances[0].pose.position.x = v; }},
        {N::InstancePosition, [](Project& p, double v) { p.instances[1].pose.position.y = v; }},
        {N::GroundHeight, [](Project& p, double v) { p.ground.height = v; }},
        {N::Gravity, [](Project& p, double v) { p.gravity.y = v; }},
        {N::Gravity, [](Project& p, double v) { p.gravity.x = v; }},
        {N::DebrisFade, [](Project& p, double v) { p.debris.fade = v; }},
        {N::ShotPosition, [](Project& p, double v) { action<Throw>(p).from.z = v; }},
        {N::ShotPosition, [](Project& p, double v) { action<Blast>(p).at.x = v; }},
        {N::ProjectileSize, [](Project& p, double v) { action<Throw>(p).size = Vec3(v); }},
        {N::ProjectileSize,
         [](Project& p, double v) {
             action<Throw>(p).kind = ProjectileKind::Ball;
             action<Throw>(p).size = Vec3(v);
         }},
        {N::Mass, [](Project& p, double v) { action<Throw>(p).mass = v; }},
        {N::ProjectileSpeed, [](Project& p, double v) { action<Throw>(p).speed = v; }},
        {N::HammerImpulse, [](Project& p, double v) { action<Hammer>(p).impulse.z = v; }},
        {N::HammerRadius, [](Project& p, double v) { action<Hammer>(p).radius = v; }},
        {N::BlastImpulse, [](Project& p, double v) { action<Blast>(p).impulse = v; }},
        {N::BlastRadius, [](Project& p, double v) { action<Blast>(p).radius = v; }},
        {N::ShotTime, [](Project& p, double v) { p.shots[0].time = v; }},
        {N::TestDuration, [](Project& p, double v) { p.playTests[0].duration = v; }},
    };
    return all;
}

/// Two blocks of three fragments over the ground; a throw, a blow and a blast at the first.
Project smallProject() {
    Project project = test::floatingBlock(3);
    asset(project).prism().outline.outer = {{0.0, 0.0}, {1.0, 0.0}, {1.0, 1.0}, {0.0, 1.0}};
    test::addInstance(project, asset(project).id, "other", {.position = {0.2, 6.2, 0.0}});
    project.gravity = {0.0, -9.81, 0.0};
    const auto add = [&](const std::string& name, double time, const ShotAction& does) {
        project.shots.push_back({.id = project.nextId++, .name = name, .time = time, .action = does});
    };
    add("box", 0.0, Throw{.size = Vec3(0.2), .mass = 50.0, .from = {0.5, 5.5, 2.0}, .to = {0.5, 5.5, 0.1}});
    add("blow", 0.3, Hammer{.at = {0.5, 5.3, 0.25}, .impulse = {0.0, 0.0, -150.0}});
    add("bomb", 0.6, Blast{.at = {0.5, 5.0, 0.0}, .impulse = 500.0, .radius = 3.0});
    project.playTests = {{.id = project.nextId++, .name = "test"}};
    return project;
}

/// A value in the range: one of its ends, right inside them, or any magnitude between.
double valueIn(const NumberRange& range, Random& random) {
    const double least = range.leastAboveZero > 0.0 ? range.leastAboveZero : range.min;
    double value = 0.0;
    switch (random.below(5)) {
        case 0: value = range.max; break;
        case 1: value = least; break;
        case 2: value = std::nextafter(range.max, 0.0); break;
        case 3: value = std::nextafter(least, range.max); break;
        default: {
            const double low = std::log(std::max({least, range.max * 1e-25, 1e-12}));
            value = std::exp(random.between(low, std::log(range.max)));
            if (range.min < 0.0 && random.below(2) == 0) value = -value;
        }
    }
    return range.contains(value) ? value : range.defaultValue;
}

double valueOutside(const NumberRange& range, Random& random) {
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    switch (random.below(6)) {
        case 0: return std::nextafter(range.max, kInfinity);
        case 1: return range.isMinExcluded ? range.min : std::nextafter(range.min, -kInfinity);
        case 2: return std::numeric_limits<double>::quiet_NaN();
        case 3: return kInfinity;
        case 4: return range.max * 1e10;
        default: return range.leastAboveZero > 0.0 ? range.leastAboveZero / 2.0 : -kInfinity;
    }
}

std::string lower(std::string text) {
    std::ranges::transform(text, text.begin(), [](unsigned char letter) { return std::tolower(letter); });
    return text;
}

/// An error must not name numbers that are none.
bool isReadable(const std::string& message) {
    return message.ends_with('.') && lower(message).find("nan") == std::string::npos &&
           lower(message).find("inf") == std::string::npos;
}

/// Plays a second. Returns the first fault found.
std::string playFault(const Project& project) {
    const Result<std::shared_ptr<const PlayScene>> scene = playScene(project);
    if (!scene) return isReadable(scene.error().message) ? "" : scene.error().message;
    Result<Session> session = Session::start(*scene);
    if (!session) return isReadable(session.error().message) ? "" : session.error().message;
    for (const Shot& shot : project.shots) {
        if (const Status added = session->add(shot); !added && !isReadable(added.error().message)) {
            return added.error().message;
        }
    }
    for (int step = 0; step < 60; ++step) {
        const std::size_t before = session->bodies().size();
        session->step();
        const PlayEvents& events = session->events();
        std::size_t reported = 0, left = 0;
        for (const Diagnostic& one : events.diagnostics) {
            if (!isReadable(one.message)) return one.message;
            if (one.code == DiagnosticCode::LeftWorld)
                ++(one.message.find("left out") == std::string::npos ? reported : left);
        }
        if (reported != events.removed.size()) return "A body was removed without a word.";
        std::size_t fragments = 0;
        for (const PlayBreak& broken : events.breaks) fragments += broken.fragmentCount;
        std::size_t thrown = 0;
        for (const PlayBody& body : events.born) thrown += body.role == PlayRole::Projectile ? 1 : 0;
        if (session->bodies().size() + reported + left + events.breaks.size() != before + fragments + thrown)
            return "A body was lost.";
        for (const PlayBody& body : session->bodies()) {
            const BodyState state = session->world().state(body.body);
            const Vec3 sum = state.pose.position + state.velocity + state.angularVelocity;
            if (!std::isfinite(sum.x + sum.y + sum.z) || !session->world().isWithinBounds(body.body))
                return "A body is beyond all bounds.";
        }
    }
    return {};
}

}  // namespace

class RangesInPlayTest : public QObject {
    Q_OBJECT
private slots:
    void limitsAreThoseOfThePhysics() {
        QCOMPARE(rangeOf(ProjectNumber::Density).max, kMaxDensity);
        QCOMPARE(rangeOf(ProjectNumber::Friction).max, kMaxFriction);
        QCOMPARE(rangeOf(ProjectNumber::Mass).min, kMinBodyMass);
        QCOMPARE(rangeOf(ProjectNumber::Mass).max, kMaxBodyMass);
        for (const ProjectNumber number :
             {ProjectNumber::InstancePosition, ProjectNumber::ShotPosition, ProjectNumber::OutlineCoordinate}) {
            QCOMPARE(rangeOf(number).max, kMaxCoordinate);
        }
        for (const ProjectNumber number : {ProjectNumber::ProjectileSpeed, ProjectNumber::HitSpeed}) {
            QCOMPARE(rangeOf(number).max, kMaxSpeed);
        }
        for (const ProjectNumber number :
             {ProjectNumber::HammerImpulse, ProjectNumber::BlastImpulse, ProjectNumber::GrabForce}) {
            QVERIFY(rangeOf(number).max <= kMaxImpulse);
        }
        QVERIFY(rangeOf(ProjectNumber::Gravity).max <= kMaxSpeed);
    }

    void projectsAreAcceptedIfTheirNumbersAreInRange() {
        constexpr std::uint64_t kSeed = 20;
        const int rounds = test::isLongRun() ? 100'000 : 5000;
        qInfo("seed %d", static_cast<int>(kSeed));
        Random random(kSeed);
        QCOMPARE(verifyProject(smallProject()).value_or(""), std::string());
        for (int round = 0; round < rounds; ++round) {
            Project project = smallProject();
            const Setter& setter = setters()[random.below(setters().size())];
            const NumberRange& range = rangeOf(setter.number);
            const bool isInside = random.below(2) == 0;
            const double value = isInside ? valueIn(range, random) : valueOutside(range, random);
            setter.set(project, value);
            const std::optional<std::string> fault = verifyProject(project);
            const std::string what = "round " + std::to_string(round) + ": " + range.name + " = " +
                                     std::to_string(value) + ": " + fault.value_or("accepted");
            QVERIFY2(fault.has_value() != isInside, what.c_str());
            const bool isNamed = !fault || fault->ends_with(", but it must be " + rangeText(range) + ".") ||
                                 setter.number == ProjectNumber::OutlineSize;  // a corner may be too far out
            QVERIFY2(isNamed, what.c_str());
        }
    }

    void numbersInRangeCanBePlayed() {
        constexpr std::uint64_t kSeed = 21;
        const int rounds = test::isLongRun() ? 20'000 : 1000;
        qInfo("seed %d", static_cast<int>(kSeed));
        Random random(kSeed);
        for (int round = 0; round < rounds; ++round) {
            Project project = smallProject();
            std::string what = "round " + std::to_string(round);
            std::set<ProjectNumber> changed;
            const std::uint64_t changes = 1 + random.below(4);
            for (std::uint64_t k = 0; k < changes; ++k) {
                const Setter& setter = setters()[random.below(setters().size())];
                if (!changed.insert(setter.number).second) continue;
                const double value = valueIn(rangeOf(setter.number), random);
                setter.set(project, value);
                what += std::string(", ") + rangeOf(setter.number).name + " = " +
                        QByteArray::number(value, 'g', 17).toStdString();
            }
            if (verifyProject(project)) continue;  // such as an outline too narrow for its coordinates
            const std::string fault = playFault(project);
            QVERIFY2(fault.empty(), (what + ": " + fault).c_str());
        }
    }
};

RUBBLE_TEST(RangesInPlayTest)
#include "RangesInPlayTest.moc"
