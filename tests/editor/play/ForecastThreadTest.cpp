// Tests editor/play/ForecastThread.cpp, and how PlayEngine orders and shows forecasts.
#include "editor/play/ForecastThread.h"

#include "tests/support/Patience.h"
#include "tests/support/TestProgram.h"
#include "tests/support/editor/PlayStage.h"

#include <QSemaphore>
#include <QTest>

using namespace rubble;

namespace {

const Ray kBesideCentre{{0.1, 5.0, 4.0}, {0.0, 0.0, -1.0}}, kPast{{5.0, 5.0, 4.0}, {0.0, 0.0, -1.0}};

std::shared_ptr<const ForecastOrder> orderOf(const Throw& thrown) {
    const std::shared_ptr<const PlayScene> scene = test::playSceneOf(test::floatingBlock());
    const Session session = Session::start(scene).value();
    return std::make_shared<const ForecastOrder>(ForecastOrder{scene, {}, session.snapshot(), thrown});
}

ChargedThrow heavy() {
    const PlayToolSettings tools = test::heavyBox();
    return {.projectile = tools.projectile, .isSpeedAutomatic = tools.isSpeedAutomatic};
}

/// What a ForecastThread has reported.
class Answers {
public:
    ForecastThread::Receiver receiver() {
        return [this](const Throw& thrown, const std::vector<BodyForecast>& bodies) {
            const std::lock_guard lock(m_mutex);
            m_answers.emplace_back(thrown, bodies);
        };
    }
    std::vector<std::pair<Throw, std::vector<BodyForecast>>> all() const {
        const std::lock_guard lock(m_mutex);
        return m_answers;
    }
    bool hasOneOf(const Throw& thrown) const {
        const auto answers = all();
        return std::ranges::any_of(answers, [&](const auto& answer) { return answer.first == thrown; });
    }

private:
    mutable std::mutex m_mutex;
    std::vector<std::pair<Throw, std::vector<BodyForecast>>> m_answers;
};

/// The same; each answer holds up the thread until it is released.
struct HeldAnswers : Answers {
    ForecastThread::Receiver receiver() {
        return [this, receive = Answers::receiver()](const Throw& thrown, const std::vector<BodyForecast>& bodies) {
            receive(thrown, bodies);
            isAnswered.release();
            isReleased.acquire();
        };
    }
    QSemaphore isAnswered, isReleased;
};

}  // namespace

class ForecastThreadTest : public QObject {
    Q_OBJECT
private slots:
    void eachAnswerIsNew() {
        Answers answers;
        ForecastThread forecasts(answers.receiver());
        const auto order = orderOf(test::throwAtBlock(20.0, 12.0));
        forecasts.start(order);
        QTRY_VERIFY_WITH_TIMEOUT(answers.hasOneOf(order->thrown), kPatience);
        forecasts.start(orderOf(test::throwAtBlock(2.0, 12.0)));
        QTRY_VERIFY_WITH_TIMEOUT(answers.hasOneOf(test::throwAtBlock(2.0, 12.0)), kPatience);
        QCOMPARE(answers.all().front().second, breakForecast(*order).value());
        QCOMPARE(answers.all().size(), std::size_t{2});  // one impact each
    }
    void missIsAnswered() {
        Answers answers;
        ForecastThread forecasts(answers.receiver());
        Throw past = test::throwAtBlock(20.0, 12.0);
        past.to.x = 3.0;
        forecasts.start(orderOf(past));
        QTRY_VERIFY_WITH_TIMEOUT(answers.hasOneOf(past), kPatience);
        QVERIFY(answers.all().front().second.empty());
    }
    void newestOrderIsCarriedOutNext() {
        HeldAnswers answers;
        ForecastThread forecasts(answers.receiver());
        const Throw first = test::throwAtBlock(20.0, 12.0), second = test::throwAtBlock(19.0, 12.0),
                    third = test::throwAtBlock(18.0, 12.0);
        forecasts.start(orderOf(first));
        QVERIFY(answers.isAnswered.tryAcquire(1, kPatience));
        forecasts.start(orderOf(second));
        forecasts.start(orderOf(third));
        answers.isReleased.release(10);
        QTRY_VERIFY_WITH_TIMEOUT(answers.hasOneOf(third), kPatience);
        QVERIFY(!answers.hasOneOf(second));
    }
    void cancelledOrderIsNotAnswered() {
        HeldAnswers answers;
        ForecastThread forecasts(answers.receiver());
        forecasts.start(orderOf(test::throwAtBlock(20.0, 12.0)));
        QVERIFY(answers.isAnswered.tryAcquire(1, kPatience));
        forecasts.start(orderOf(test::throwAtBlock(19.0, 12.0)));
        forecasts.cancel();
        answers.isReleased.release(10);
        forecasts.start(orderOf(test::throwAtBlock(18.0, 12.0)));
        QTRY_VERIFY_WITH_TIMEOUT(answers.hasOneOf(test::throwAtBlock(18.0, 12.0)), kPatience);
        QVERIFY(!answers.hasOneOf(test::throwAtBlock(19.0, 12.0)));
    }
    void engineOrdersAForecastOfEachThrow() {
        const auto engine = PlayEngine::create(test::playSceneOf(test::floatingBlock()), {}).value();
        engine->aim(heavy(), test::kAtBlock);
        QVERIFY(!engine->takeUpdate().order);  // not shown
        engine->setOverlays({.hasHeat = true});
        const auto order = engine->takeUpdate().order;
        QVERIFY(order);
        engine->aim(heavy(), test::kAtBlock);
        PlayUpdate update = engine->takeUpdate();
        QVERIFY(!update.order && !update.frame->hasForecast);  // the same throw
        engine->setForecast(order->thrown, {{.body = 1, .largest = 2.0}});
        QVERIFY(engine->takeUpdate().frame->hasForecast);
        engine->aim(heavy(), kBesideCentre);
        update = engine->takeUpdate();
        QVERIFY(update.order && !update.frame->hasForecast);
        engine->setForecast(order->thrown, {{.body = 1, .largest = 2.0}});  // too late
        QVERIFY(!engine->takeUpdate().frame->hasForecast);
    }
    void aimedThrowIsForecast() {
        test::Stage stage;
        stage.controller.setOverlays({.hasHeat = true});
        stage.start();
        stage.controller.pause();
        for (const Ray& ray : {test::kAtBlock, kPast, test::kAtBlock}) {
            stage.controller.aim(ray);
            const auto isShown = [&] {
                stage.settle();
                return stage.controller.frame()->hasForecast;
            };
            QTRY_VERIFY_WITH_TIMEOUT(isShown(), kPatience);
        }
    }
};

RUBBLE_TEST_WITH(ForecastThreadTest, QCoreApplication)
#include "ForecastThreadTest.moc"
