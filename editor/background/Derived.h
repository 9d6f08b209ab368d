#pragma once

#include "editor/background/DerivedState.h"

#include <QCoreApplication>

#include <functional>
#include <memory>
#include <utility>

namespace rubble {

/// A value that is computed in the background from a document, anew when that changes. Value is default-constructible:
/// empty.
template <class Value>
class Derived : public DerivedState {
public:
    /// Sets an incomplete value, which is shown while the rest is computed.
    using Publish = std::function<void(Value incomplete)>;
    /// Computes the value in the background, from copies.
    using Work = std::function<Result<Value>(const TaskContext& task, const Publish& publish)>;
    /// Copies what the work needs; called in the thread of the document when the work is to start. No work: there is
    /// nothing to do before the next change, as where an asset is still being baked. An error: the result has failed.
    using Preparation = std::function<Result<Work>()>;

    /// Computes the value from now on; without a preparation, from the first request on.
    explicit Derived(DerivedFrom from, Preparation prepare = {}, QObject* parent = nullptr)
        : DerivedState(std::move(from), parent), m_prepare(std::move(prepare)) {
        if (m_prepare) restart();
    }

    /// The last value, perhaps outdated or incomplete. Empty before the first one, and after a failure unless something
    /// was published.
    const Value& value() const { return m_value; }
    /// Computes another value, now and after changes. Until it is there, the earlier one is kept.
    void request(Preparation prepare) {
        m_prepare = std::move(prepare);
        startRequested();
    }

private:
    Status startJob() override {
        Result<Work> prepared = m_prepare();
        if (!prepared) return prepared.error();
        if (!*prepared) return success();
        m_job.start(
            [this, work = std::move(*prepared), doing = doing()](const TaskContext& task,
                                                                 const BackgroundJob::Post& post) -> Result<Value> {
                const Publish publish = [&](Value incomplete) {
                    post([this, shared = std::make_shared<Value>(std::move(incomplete))] {
                        m_value = std::move(*shared);
                        setPublished();
                    });
                };
                return orOutOfMemory(doing, [&] { return work(task, publish); });
            },
            [this](Result<Value>&& result) { deliver(result); });
        return success();
    }
    void deliver(Result<Value>& result) {
        if (!result) return fail(result.error());
        m_value = std::move(*result);
        setReady();
    }
    void dropValue() override { m_value = Value(); }

    Preparation m_prepare;
    Value m_value{};
};

}  // namespace rubble
