#pragma once

#include "core/base/TaskContext.h"
#include "viewport/render/Renderer.h"
#include "viewport/scene/Take.h"

#include <filesystem>
#include <span>

namespace rubble {

/// Which moments of a play become pictures, how they are seen, and how fast they follow each other in a film.
struct FilmPlan {
    PictureView view;    // of each take; its moment says nothing
    int samples = 8;     // see pictureOf()
    double first = 0.0;  // steps into the play, >= 0: the first picture
    double every = 1.0;  // steps from picture to picture, > 0; between two steps things are drawn on their way
    int pictures = 1;    // at most kMostPictures
    double rate = 30.0;  // pictures a second
};

/// How many pictures show a play from one step to another.
int picturesBetween(double first, double last, double every);

/// What becomes of the pictures of a film that is cancelled or cannot be finished.
enum class Unfinished { Kept, Removed };

/// Draws takes moment by moment without a display, side by side where there are several, and writes their pictures: see
/// PictureSequence. The takes have not begun.
///
/// Errors: those of PictureMaker and of PictureSequence; Cancelled.
Status filmPictures(std::span<Take> takes, const FilmPlan& plan, const std::filesystem::path& folder,
                    Unfinished unfinished, const TaskContext& task = {});

/// The same as a film: see encodeFilm(). Its pictures lie beside it until it is made; they are always removed.
///
/// Errors: those of filmPictures() and encodeFilm().
Status filmFile(std::span<Take> takes, const FilmPlan& plan, const std::filesystem::path& film,
                const TaskContext& task = {});

}  // namespace rubble
