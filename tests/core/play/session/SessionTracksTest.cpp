#include "core/play/session/SessionTracks.h"

#include "tests/support/TestProgram.h"
#include "tests/support/asset/House.h"
#include "tests/support/play/BondedWalls.h"
#include "tests/support/play/Sessions.h"

#include <algorithm>
#include <map>
#include <random>

using namespace rubble;

namespace {

constexpr double kReach = 1e-5;  // m: of numbers in single precision, ten metres away

/// The pose of a track in a frame, and its size.
struct Shown {
    Pose pose;
    double size = 0.0;
};

Shown shownAt(const std::vector<PoseKey>& poses, const std::vector<SizeKey>& sizes, std::uint32_t frame) {
    Shown shown;
    for (const SizeKey& key : sizes) {
        if (key.frame <= frame) shown.size = double{key.size};
    }
    const auto next = std::ranges::lower_bound(poses, frame, {}, &PoseKey::frame);
    const PoseKey& to = next == poses.end() ? poses.back() : *next;
    const PoseKey& from = next == poses.begin() ? to : *std::prev(next);
    const double fraction =
        to.frame <= from.frame || frame > to.frame ? 1.0 : double(frame - from.frame) / double(to.frame - from.frame);
    shown.pose.position = glm::mix(Vec3(from.position), Vec3(to.position), fraction);
    shown.pose.orientation = glm::slerp(Quat(from.orientation), Quat(to.orientation), fraction);
    return shown;
}

using Solid = std::tuple<std::string, const void*, std::uint32_t>;

/// The corners of what is there in a session.
std::map<Solid, std::vector<Vec3>> cornersOf(const Session& session) {
    std::map<Solid, std::vector<Vec3>> corners;
    for (const PlayBody& body : session.bodies()) {
        if (body.role == PlayRole::Ground || session.fadeOf(body) >= 1.0) continue;
        const BodyState state = session.world().state(body.body);
        const double fade = session.fadeOf(body);
        forEachSolid(body, false, [&](std::uint32_t fragment, Vec3 offset) {
            const void* shape = body.asset ? static_cast<const void*>(body.asset.get()) : body.hull.get();
            std::vector<Vec3>& points = corners[{session.origins()[body.origin].name, shape, fragment}];
            std::vector<Polytope> hulls;
            if (body.asset == nullptr)
                hulls = {*body.hull};
            else if (fragment == kNone)
                hulls = wholeHullsInPrism(*body.asset->bake);
            else
                hulls = body.asset->bake->fragment(fragment).solid.hulls();
            for (const Polytope& hull : hulls) {
                for (const Vec3& vertex : hull.vertices) {
                    const Vec3 point = state.pose.position + state.pose.orientation * (vertex + offset);
                    points.push_back(glm::mix(point, state.centre, fade));
                }
            }
        });
    }
    return corners;
}

/// The same corners in a frame of tracks.
std::map<Solid, std::vector<Vec3>> cornersAt(const SessionTracks& tracks, std::uint32_t frame, double tolerance) {
    std::map<Solid, std::vector<Vec3>> corners;
    for (const SolidTrack& track : tracks.solids) {
        std::vector<Polytope> hulls;
        Vec3 origin(0.0);
        if (track.asset == nullptr)
            hulls = {*track.hull};
        else if (track.fragment == kNone) {
            hulls = wholeHullsInPrism(*track.asset->bake);
            origin = track.asset->bake->whole.centre;
        } else
            hulls = track.asset->bake->fragment(track.fragment).solid.hulls();
        double radius = 0.0;
        for (const Polytope& hull : hulls) {
            for (const Vec3& vertex : hull.vertices) radius = std::max(radius, glm::length(vertex - origin));
        }
        const std::vector<PoseKey> poses = tolerance > 0.0 ? reducedPoses(track.poses, radius, tolerance) : track.poses;
        const Shown shown = shownAt(poses, track.sizes, frame);
        if (shown.size <= 0.0) continue;
        const void* shape = track.asset ? static_cast<const void*>(track.asset.get()) : track.hull.get();
        std::vector<Vec3>& points = corners[{track.origin, shape, track.fragment}];
        for (const Polytope& hull : hulls) {
            for (const Vec3& vertex : hull.vertices) {
                points.push_back(shown.pose.position + shown.pose.orientation * (shown.size * (vertex - origin)));
            }
        }
    }
    return corners;
}

/// The farthest that any corner is from where it was; -1 where other solids are there.
double errorOf(const std::map<Solid, std::vector<Vec3>>& then, const std::map<Solid, std::vector<Vec3>>& now) {
    if (then.size() != now.size()) return -1.0;
    double error = 0.0;
    for (const auto& [solid, points] : then) {
        const auto found = now.find(solid);
        if (found == now.end() || found->second.size() != points.size()) return -1.0;
        for (std::size_t k = 0; k < points.size(); ++k) {
            error = std::max(error, glm::length(points[k] - found->second[k]));
        }
    }
    return error;
}

}  // namespace

class SessionTracksTest : public QObject {
    Q_OBJECT

    /// Plays shots of a scene, and compares every frame of its tracks with the session.
    static void compareFrames(const std::shared_ptr<const PlayScene>& scene, int steps, std::uint64_t every) {
        Result<Session> session = Session::start(scene);
        for (const Shot& shot : scene->project.shots) QVERIFY(session->add(shot).hasValue());
        TrackRecorder recorder(*session, every);
        std::vector<std::map<Solid, std::vector<Vec3>>> frames{cornersOf(*session)};
        for (int step = 1; step <= steps; ++step) {
            session->step();
            QVERIFY(recorder.add(*session).hasValue());
            if (static_cast<std::uint64_t>(step) % every == 0) frames.push_back(cornersOf(*session));
        }
        const SessionTracks tracks = std::move(recorder).tracks();
        QCOMPARE(tracks.lastFrame + 1, frames.size());
        QCOMPARE(tracks.frameLength, session->stepLength() * double(every));
        for (std::uint32_t frame = 0; frame <= tracks.lastFrame; frame += 7) {
            const double error = errorOf(frames[frame], cornersAt(tracks, frame, 0.0));
            QVERIFY2(error >= 0.0 && error < kReach, qPrintable(QString("frame %1: %2").arg(frame).arg(error)));
            const double reduced = errorOf(frames[frame], cornersAt(tracks, frame, 1e-4));
            QVERIFY2(reduced >= 0.0 && reduced < 1e-4 + kReach, qPrintable(QString("%1: %2").arg(frame).arg(reduced)));
        }
        std::size_t all = 0, kept = 0;
        for (const SolidTrack& track : tracks.solids) {
            QVERIFY(std::ranges::is_sorted(track.poses, std::ranges::less_equal(), &PoseKey::frame));
            QVERIFY(std::ranges::is_sorted(track.sizes, std::ranges::less_equal(), &SizeKey::frame));
            QCOMPARE(track.sizes.front().frame, 0u);
            all += track.poses.size();
            kept += reducedPoses(track.poses, 1.0, 1e-4).size();
        }
        QVERIFY(kept < all);
        QVERIFY(all < frames.size() * tracks.solids.size());  // what rests has no keys
    }

private slots:
    void framesShowWhatTheSessionHas_data() {
        QTest::addColumn<int>("every");
        QTest::newRow("each step") << 1;
        QTest::newRow("each third step") << 3;
    }
    void framesShowWhatTheSessionHas() {
        QFETCH(int, every);
        compareFrames(test::playSceneOf(test::house()), 200, static_cast<std::uint64_t>(every));
    }

    void removedDebrisShrinks() {
        Project project = test::house();
        project.debris.lifetime = 1.5;
        compareFrames(test::playSceneOf(project), 240, 1);
    }

    void partsOfABondedAssetMoveOnTheirOwn() {
        Project project = test::bondedWall();
        test::addShot(project, "ball", 0.0, test::ballAtWall());
        compareFrames(test::playSceneOf(project), 120, 1);
    }

    void reducedPosesAreWithinTheTolerance() {
        constexpr std::uint32_t kSeed = 41;
        std::mt19937 random(kSeed);
        std::uniform_real_distribution<float> speed(-5.0f, 5.0f);
        for (int round = 0; round < 200; ++round) {
            const glm::vec3 velocity(speed(random), speed(random), speed(random));
            const glm::vec3 axis = glm::normalize(glm::vec3(speed(random), speed(random), 1.0f));
            const float rate = speed(random) * 4.0f;
            std::vector<PoseKey> poses;
            for (std::uint32_t frame = 0; frame < 300; ++frame) {
                const float time = static_cast<float>(frame) / 60.0f;
                if (frame > 0 && speed(random) > 4.5f) continue;  // a gap
                poses.push_back({frame, velocity * time + glm::vec3(0.0f, -5.0f * time * time, 0.0f),
                                 glm::angleAxis(rate * time, axis)});
            }
            const std::vector<PoseKey> kept = reducedPoses(poses, 0.5, 1e-3);
            QCOMPARE(kept.front(), poses.front());
            QCOMPARE(kept.back(), poses.back());
            for (const PoseKey& pose : poses) {
                const Shown shown = shownAt(kept, {}, pose.frame);
                for (const Vec3 corner : {Vec3(0.5, 0.0, 0.0), Vec3(0.0, 0.5, 0.0), Vec3(0.0, 0.0, 0.5)}) {
                    const Vec3 then = Vec3(pose.position) + Quat(pose.orientation) * corner;
                    const double error = glm::length(then - shown.pose.position - shown.pose.orientation * corner);
                    QVERIFY2(error < 1.05e-3, qPrintable(QString("seed %1: %2 m").arg(kSeed).arg(error)));
                }
            }
        }
    }

    void whatNeverMovesHasOnePose() {
        const std::shared_ptr<const PlayScene> scene = test::playSceneOf(test::house());
        Result<Session> session = Session::start(scene);
        session->sleepInPlace();
        TrackRecorder recorder(*session);
        for (int step = 0; step < 10; ++step) {
            session->step();
            QVERIFY(recorder.add(*session).hasValue());
        }
        const SessionTracks tracks = std::move(recorder).tracks();
        QCOMPARE(tracks.solids.size(), std::size_t{77});
        for (const SolidTrack& track : tracks.solids) {
            QCOMPARE(track.poses.size(), std::size_t{1});
            QCOMPARE(track.sizes, (std::vector<SizeKey>{{0, 1.0f}}));
        }
    }
};

RUBBLE_TEST(SessionTracksTest)
#include "SessionTracksTest.moc"
