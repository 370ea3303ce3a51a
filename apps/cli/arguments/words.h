// SPDX-License-Identifier: Apache-2.0
// Unknown words of the command line, and the words that the user may have meant.
#pragma once
#include <string>
#include <vector>

namespace CLI {
class App;
class ParseError;
}  // namespace CLI

namespace avo_cli {

/// Returns the verb. Throws UsageError with the nearest verb if there is no such verb.
const CLI::App& verb_of(const CLI::App& app, const std::string& word);

/// Throws UsageError if the first word is no verb or option of `app`, or if a later word is no
/// option of the verb.
void check_words(const CLI::App& app, const std::vector<std::string>& words);

/// Returns the message for an error that parsing `app` threw.
std::string what_is_wrong(const CLI::App& app, const CLI::ParseError& error);

/// Prints avo help VERB; for an empty verb the help of all verbs.
int print_help(const CLI::App& app, const std::string& verb);

}  // namespace avo_cli
