#pragma once

#include "core/base/OutOfMemory.h"
#include "editor/document/Bakes.h"
#include "editor/document/Document.h"
#include "editor/document/jobs/BackgroundJob.h"

#include <QTimer>

#include <optional>
#include <vector>

namespace rubble {

/// What happens to a derived result when something that it depends on changes.
enum class OnChange {
    Restart,  // it is computed again, and the earlier one is kept until then
    Discard,  // it is dropped until the next request
};

/// For what depends on the whole project.
inline const std::vector<Part> kEveryPart{Part::Material, Part::Asset,  Part::Instance, Part::Shot,
                                          Part::PlayTest, Part::Mortar, Part::Scene};

inline constexpr int kDerivedDelayMilliseconds = 120;  // a dragged seed bakes many times a second

/// What a derived result depends on.
struct DerivedFrom {
    const Document& document;
    std::vector<Part> parts;       // the result is outdated when one of these changes
    const char* doing;             // for errors: "finding the joints of mortar"
    const Bakes* bakes = nullptr;  // or one of these; null: none
    OnChange onChange = OnChange::Restart;
    int delayMilliseconds = kDerivedDelayMilliseconds;  // without changes, before it is computed again
};

/// The state of a result that is computed in the background from a document; Derived adds the value.
///
/// A change cancels a running computation. Every computation that is not cancelled ends in Ready or Failed, also where
/// memory runs out, so that nothing stays pending with an error that nobody sees.
class DerivedState : public QObject {
    Q_OBJECT
public:
    enum class State {
        Idle,     // not requested, cancelled or discarded
        Pending,  // waits until nothing changes or a bake is finished, or is being computed
        Ready,
        Failed,  // error() says why
    };

    State state() const { return m_state; }
    bool isPending() const { return m_state == State::Pending; }
    /// Whether there is a value, and it is that of the current document.
    bool isCurrent() const { return m_state == State::Ready; }
    /// Why the last computation failed; a restart keeps it until the next one ends. To be shown in place of the value.
    const std::optional<Error>& error() const { return m_error; }

    /// As a change does: computes the result again after the delay if one was requested, or discards it.
    void invalidate();
    /// Drops value and error and computes the result again after the delay: as for another project.
    void restart();
    /// Drops value and error and computes nothing until the next request.
    void reset();
    /// Ends a computation; what it published and earlier values are kept. Nothing is computed until the next request.
    void cancel();

signals:
    /// The value, the error, or whether a request is pending. Not that a value is outdated.
    void changed();
    /// The fraction of the computation that is done, in [0, 1].
    void progressed(double fraction);
    /// The computation failed; the sentence is that of error().
    void failed(const QString& sentence);

protected:
    DerivedState(DerivedFrom from, QObject* parent);

    const Project& project() const { return m_from.document.project(); }
    const char* doing() const { return m_from.doing; }
    /// Computes the result at once, for a request.
    void startRequested();
    /// Starts the job, or waits for the next change. Errors: those of the preparation; then the result has failed.
    virtual Status startJob() = 0;
    virtual void dropValue() = 0;
    /// A value was set: the final one, or an incomplete one.
    void setReady();
    void setPublished();
    void fail(Error error);

    BackgroundJob m_job;

private:
    void receive(const Changes& changes);
    void start();
    void drop();

    const DerivedFrom m_from;
    QTimer m_delay;
    State m_state = State::Idle;
    std::optional<Error> m_error;
    bool m_hasValue = false;
    bool m_hasPublished = false;  // the running computation
};

}  // namespace rubble
