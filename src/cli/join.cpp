// SPDX-License-Identifier: Apache-2.0
// glint join: parts of a picture to the picture.
#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "base/text.h"
#include "cli/commands.h"
#include "cli/failure.h"
#include "cli/journal_picture.h"
#include "cli/picture_endings.h"
#include "cli/picture_output.h"
#include "cli/print_error.h"
#include "cli/text.h"

namespace glint::cli {
namespace {

constexpr auto k_join_examples = R"(Examples:
  glint join 1.tiles 2.tiles 3.tiles -o castle.png      what three runs with --part rendered
  glint join *.tiles -o castle.exr --partial            the tiles that there are, the others black
  glint join castle.png.journal -o now.png --partial    how far a run with --resume has come)";

struct JoinArguments {
    std::vector<std::string> files;
    NumberArguments numbers;
    std::string output;
    bool partial = false, quiet = false;
};

std::vector<JournalInput> read_journals(const std::vector<std::string>& names) {
    std::vector<JournalInput> inputs;
    for (const std::string& name : names) {
        std::string why;
        std::optional<InputFile> file = InputFile::open(name, why, true);
        if (!file) throw Failure(k_bad_input, fmt::format("{}: {}", name, why));
        Result<JournalInput> input = read_journal(name, std::move(*file));
        if (!input) throw Failure(k_bad_input, fmt::format("{}: {}", name, input.message));
        if (!inputs.empty()) {
            why = header_difference(input->journal.header, inputs.front().journal.header);
            if (!why.empty()) {
                throw Failure(k_bad_input,
                              fmt::format("{} and {} are of different pictures: {} (there: {}, here: {})",
                                          name, inputs.front().name, why, name, inputs.front().name));
            }
        }
        inputs.push_back(*std::move(input));
    }
    return inputs;
}

// What is missing, by part where all files have the same number of parts.
std::string missing_text(const std::vector<JournalInput>& inputs, const JournalPicture& tiles) {
    JournalHeader header = tiles.header();
    const std::size_t all = count_tiles(header.picture);
    std::string text =
        fmt::format("{} of {} tiles are missing", with_commas(all - tiles.count_present()), with_commas(all));
    const bool same_parts = std::all_of(inputs.begin(), inputs.end(), [&](const JournalInput& input) {
        return input.journal.header.parts == header.parts;
    });
    if (!same_parts || header.parts == 1) return text;
    int named = 0;
    const std::size_t last = std::min<std::size_t>(header.parts, all);  // others have no tiles
    for (header.part = 1; header.part <= last; ++header.part) {
        const std::vector<std::uint32_t> part = tiles_of_part(header);
        const auto lacking =
            std::count_if(part.begin(), part.end(), [&](std::uint32_t tile) { return !tiles.has(tile); });
        if (lacking == 0) continue;
        if (++named > 10) return text + " ...";
        text += fmt::format("{} {} of the {} of part {}/{}", named == 1 ? ":" : ",", lacking, part.size(),
                            header.part, header.parts);
    }
    return text;
}

int join_command(const JoinArguments& arguments) {
    const std::vector<JournalInput> inputs = read_journals(arguments.files);
    const JournalHeader& header = inputs.front().journal.header;
    const PictureOutput picture(picture_destination(arguments.output, arguments.numbers, false),
                                contents_of(header), 0);
    const JournalPicture tiles(inputs);
    for (const JournalInput& input : inputs) {
        if (input.journal.damaged)
            print_error("warning: {}: cut or damaged after its {}; the rest is left out\n", input.name,
                        counted(input.journal.tiles.size(), "tile"));
    }
    const std::size_t all = count_tiles(header.picture);
    if (tiles.count_present() < all) {
        const std::string missing = missing_text(inputs, tiles);
        if (!arguments.partial)
            throw Failure(k_bad_input, missing + "; --partial writes a picture of those that there are");
        if (!arguments.quiet) print_error("warning: {}\n", missing);
    }
    picture.write(tiles);
    if (!arguments.quiet) {
        print_error("{}  {}x{}  {} of {}\n", arguments.output, header.picture.width, header.picture.height,
                    with_commas(tiles.count_present()), counted(all, "tile"));
    }
    return k_done;
}

}  // namespace

Run add_join(CLI::App& app) {
    CLI::App& command = *app.add_subcommand("join", "Make a picture of the parts that render --part wrote");
    const auto arguments = std::make_shared<JoinArguments>();
    JoinArguments& a = *arguments;
    command.add_option("FILE", a.files, "Parts of one picture (.tiles) or journals, in any order")
        ->option_text("...")
        ->required();
    command
        .add_option("-o,--output", a.output,
                    fmt::format("The picture: {}. Its layers are those that were rendered with --aov",
                                k_picture_endings_text))
        ->option_text("OUT")
        ->required();
    add_number_arguments(command, a.numbers);
    command.add_flag("--partial", a.partial, "Write the picture even if tiles are missing; they are black");
    command.add_flag("-q,--quiet", a.quiet, "Say nothing but errors");
    command.footer(k_join_examples);
    return [arguments] { return join_command(*arguments); };
}

}  // namespace glint::cli
