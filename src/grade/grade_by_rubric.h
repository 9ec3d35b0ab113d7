// SPDX-License-Identifier: Apache-2.0
#pragma once
// The points of every submission, part by part of a rubric, with the causes of what is wrong.
#include <atomic>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "glint/compare.h"
#include "glint/result.h"
#include "grade/grading.h"

namespace glint {

/// A picture that a submission has for a part.
struct HandedIn {
    std::string path;   ///< empty: none was handed in
    std::string error;  ///< why there is no picture: "no file *phong*.png", or why it cannot be read
    Image image;
    std::string note = {};  ///< DecodedImage::note
};

/// The submissions of a class. The functions are called on the thread of grade_by_rubric().
class Submissions {
  public:
    virtual ~Submissions() = default;
    /// Their names, in the order of the results.
    virtual std::vector<std::string> names() const = 0;
    /// The picture that submission number `submission` has for the row. It is called twice for the pictures
    /// of programs with faults.
    virtual HandedIn find(std::size_t submission, const RubricRow& row) = 0;

    // What is judged, for a contact sheet.
    /// The picture that the row requires.
    virtual void show_wanted(std::size_t /*row*/, const Image& /*wanted*/) {}
    /// A picture that was handed in, and the one that the row requires; null if it has another size.
    virtual void show(std::size_t /*submission*/, std::size_t /*row*/, const Image& /*picture*/,
                      const Image* /*wanted*/) {}
    /// Row number `to` has the pictures of row number `from`, which have been shown.
    virtual void show_same(std::size_t /*from*/, std::size_t /*to*/) {}
};

/// One part of a rubric, of one submission.
struct GradedPart {
    std::string path;   ///< of the picture; empty: none was handed in
    std::string error;  ///< the reason why there are no points: "no file *phong*.png"
    PartScore score;
    std::optional<Cause> cause;  ///< of the difference
    std::vector<Cause> then;     ///< further causes, together with the first
    std::string remark;          ///< CauseReport::remark, if there is no cause
    std::string note;            ///< HandedIn::note
    /// The faults of the program with which the picture was judged, because that gives more points; none if
    /// it was judged as it is.
    std::vector<std::string> followed;
    /// For each of these, the part that it costs points, or "a penalty"; empty: none.
    std::vector<std::string> counted_in;
    double points_alone = 0;  ///< the points without them
};

struct GradedSubmission {
    std::string name;
    std::vector<GradedPart> parts;         ///< as the rubric's rows
    std::vector<RubricPenalty> penalties;  ///< for faults of the program, each once
    std::vector<Cause> faults;             ///< of the program: those with which other parts can be judged
    /// The parts' points less the penalties, at least 0, to hundredths.
    double total() const;
};

struct RubricOptions {
    int threads = 0;
    std::function<void(double)> progress = {};  ///< with the fraction done; called on the calling thread
    CancelFlag cancel = {};
};

/// Grades all parts of all submissions. The points do not depend on the order of the rubric's rows. Fails if
/// a part cannot be rendered.
Result<std::vector<GradedSubmission>> grade_by_rubric(const Scene& scene, const Rubric& rubric,
                                                      Submissions& submissions,
                                                      const RubricOptions& options = {});

}  // namespace glint
