// SPDX-License-Identifier: Apache-2.0
#pragma once
// What the options of POV-Ray's command lines and .ini files say, and what it means for glint.
#include <string>
#include <vector>

#include "cli/drop_in.h"
#include "cli/drop_in_animation.h"
#include "cli/foreign_table.h"

namespace glint::cli {

/// Where an option is written.
struct OptionPlace {
    std::string text;         ///< "povray.ini:3"; empty: on the command line
    std::string file;         ///< the .ini file
    bool is_trusted = false;  ///< the file is one of the user's or the system's own
};

/// The options so far, with POV-Ray's defaults for the others.
class PovrayOptions {
  public:
    /// A switch: `word` is +KEY VALUE or -KEY VALUE. Throws a usage Failure, as all functions here.
    void set(PovrayKey key, const std::string& value, bool on, const std::string& word);
    /// `word` is KEY = VALUE; some keys have values that differ from those of their switches.
    void set(const PovraySwitch& known, const std::string& value, const std::string& word);
    void set_input(const std::string& name);
    /// For glint's own flags.
    DropIn& parsed() { return parsed_; }
    /// With the arguments of `glint render`, unless the help or the version is wanted.
    DropIn finish();
    [[noreturn]] void fail(const std::string& message) const;

    /// Of the options that are set next.
    OptionPlace place;

  private:
    // drop_in_povray_options.cpp
    void warn(const std::string& message);
    double number(const std::string& value, const std::string& word, double most) const;
    double any_number(const std::string& value, const std::string& word) const;
    void declare(const std::string& name, const std::string& value, const std::string& word);
    void set_file_type(const std::string& value, const std::string& word);
    void set_quality(double quality);

    // drop_in_povray_render.cpp
    void set_render_arguments();
    void set_part();
    void set_frames();
    void check_output(const std::string& path) const;
    std::string find_input();
    std::string output_path() const;

    // Who names a file: the place in an .ini file, and its folder; none if it is the user.
    struct Namer {
        std::string place, folder;
    };
    Namer namer() const;

    DropIn parsed_;
    std::string input_, output_;
    Namer input_by_, output_by_;
    Animation animation_;
    PartOfSide columns_, rows_;
    int jpeg_quality_ = 85;  // POV-Ray's default, measured
    std::vector<std::string> folders_;
    int width_ = 320, height_ = 240;
    bool antialias_ = false, writes_ = true;
    double threshold_ = 0.3;
    int depth_of_samples_ = 3;
};

}  // namespace glint::cli
