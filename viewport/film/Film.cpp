#include "viewport/film/Film.h"

#include "core/io/FilmFile.h"
#include "core/io/PictureSequence.h"
#include "viewport/render/Picture.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <system_error>

namespace rubble {

namespace fs = std::filesystem;

namespace {

constexpr int kGap = 8;                // pixels between two takes
constexpr double kDrawingShare = 0.9;  // of the time that a film takes; the rest is ffmpeg's

/// The moment of all takes after so many steps, side by side. Between two steps it is on the way to the later one.
Result<Image> pictureAt(std::span<Take> takes, PictureMaker& maker, const FilmPlan& plan, double time,
                        const TaskContext& task) {
    constexpr double kRounding = 1e-6;  // steps: what sums of fractions are off
    const double step = std::max(0.0, std::ceil(time - kRounding));
    PictureView view = plan.view;
    view.moment = std::clamp(1.0 - (step - time), 0.0, 1.0);
    std::optional<Image> picture;
    for (Take& take : takes) {
        const auto moment = take.momentAfter(static_cast<std::uint64_t>(step), task);
        if (!moment) return moment.error();
        Result<Image> image = maker.pictureOf(*moment, view, plan.samples, task);
        if (!image) return image.error();
        picture = picture ? besideEachOther(*picture, *image, kGap) : std::move(*image);
    }
    return std::move(*picture);
}

Status shoot(std::span<Take> takes, const FilmPlan& plan, PictureSequence& sequence, const TaskContext& task) {
    Result<PictureMaker> maker = PictureMaker::made();
    if (!maker) return maker.error();
    const TaskContext part{.cancel = task.cancel};
    for (int picture = 0; picture < plan.pictures; ++picture) {
        const Result<Image> image = pictureAt(takes, *maker, plan, plan.first + picture * plan.every, part);
        if (!image) return image.error();
        const Result<std::string> png = pngOf(*image);
        if (!png) return png.error();
        if (const Status added = sequence.add(*png); !added) return added;
        task.report(static_cast<double>(picture + 1) / plan.pictures);
    }
    return success();
}

/// Where nothing is, beside a film.
fs::path pictureFolderOf(const fs::path& film) {
    std::error_code ignored;
    for (int k = 0;; ++k) {
        const fs::path folder = film.parent_path() / ("." + film.filename().string() + "." + std::to_string(k));
        if (!fs::exists(folder, ignored)) return folder;
    }
}

}  // namespace

int picturesBetween(double first, double last, double every) {
    constexpr double kRounding = 1e-6;  // steps: what quotients of fractions are off
    const double pictures = std::floor((last - first) / every + kRounding) + 1.0;
    return static_cast<int>(std::clamp(pictures, 1.0, 1e9));
}

Status filmPictures(std::span<Take> takes, const FilmPlan& plan, const fs::path& folder, Unfinished unfinished,
                    const TaskContext& task) {
    const auto sequence = PictureSequence::begun(folder);
    if (!sequence) return sequence.error();
    const Status shot = shoot(takes, plan, **sequence, task);
    if (shot || unfinished == Unfinished::Kept) (*sequence)->keep();
    return shot;
}

Status filmFile(std::span<Take> takes, const FilmPlan& plan, const fs::path& film, const TaskContext& task) {
    const fs::path folder = pictureFolderOf(film);
    const auto sequence = PictureSequence::begun(folder);  // which removes it in the end
    if (!sequence) return sequence.error();
    const Status shot = shoot(takes, plan, **sequence, task.stage(0.0, kDrawingShare));
    return shot ? encodeFilm(folder, plan.rate, film, task) : shot;
}

}  // namespace rubble
