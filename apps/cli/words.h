// SPDX-License-Identifier: Apache-2.0
// The words of the command line that are not known, and those that may have been meant.
#pragma once
#include <string>
#include <vector>

namespace CLI {
class App;
class ParseError;
}  // namespace CLI

namespace avo_cli {

/// Throws UsageError with the nearest verb where there is no such one.
const CLI::App& verb_of(const CLI::App& app, const std::string& word);

/// Throws UsageError where the first word is no verb or option of `app`, or a later one no option
/// of the verb.
void check_words(const CLI::App& app, const std::vector<std::string>& words);

/// What the user is told of an error that parsing `app` threw.
std::string what_is_wrong(const CLI::App& app, const CLI::ParseError& error);

/// avo help VERB; an empty one: of all verbs.
int print_help(const CLI::App& app, const std::string& verb);

}  // namespace avo_cli
