// SPDX-License-Identifier: Apache-2.0
// paper_figures FOLDER: the figures of the paper and a README.md about them; it makes FOLDER.
#include <cstdio>
#include <exception>
#include <filesystem>

#include "avo_io/output_file.h"
#include "figures_of_the_paper.h"

namespace avo::paper {

void save(const std::string& path, const std::string& bytes) {
  avo_io::OutputFile file(path);
  file.write(bytes);
  file.commit();
}

std::string format(const char* pattern, double value) {
  char text[64];
  std::snprintf(text, sizeof text, pattern, value);
  return text;
}

namespace {

// Removes spaces at the end: sentences end with a space, but paragraphs do not.
std::string paragraph(std::string text) {
  while (!text.empty() && text.back() == ' ') text.pop_back();
  return text;
}

std::string readme(const std::vector<Caption>& captions) {
  std::string text =
      "# Figures of the paper\n\n"
      "Made by `scripts/paper` from this library; the numbers come from the same runs. The paper "
      "is van den Berg, Snape, Guy, Manocha, *Reciprocal Collision Avoidance with "
      "Acceleration-Velocity Obstacles*, ICRA 2011. The method is the paper's (`avo_paper`), with "
      "exact half-planes instead of 25 samples. A collision is an overlap of two discs at any "
      "time, also between two steps.\n";
  for (const Caption& caption : captions) {
    text += "\n## Fig. " + caption.number + ": " + caption.title + "\n\n![" + caption.title + "](" +
            caption.file + ")\n\n" + paragraph(caption.shows) + "\n\n**Agrees:** " +
            paragraph(caption.agrees) + "\n";
    if (!caption.differs.empty()) text += "\n**Differs:** " + paragraph(caption.differs) + "\n";
    if (!caption.runs.empty()) text += "\n";
    for (const std::string& run : caption.runs)
      text += "<!-- drawn by scripts/paper: " + run + " -->\n";
  }
  return text;
}

void draw_all(const std::string& folder) {
  std::printf("%s\n", draw_states(folder).c_str());
  using Draw = Caption (*)(const std::string&);
  std::vector<Caption> captions;
  for (const Draw draw :
       {Draw{draw_exchange}, Draw{draw_velocity_obstacle}, Draw{draw_acceleration_obstacle},
        Draw{draw_among_movers}, Draw{draw_reciprocal_sets}, Draw{draw_half_planes},
        Draw{draw_car_accelerations}, Draw{draw_moving_obstacle}, Draw{draw_circle},
        Draw{draw_cars}, Draw{draw_speed}}) {
    captions.push_back(draw(folder));
    std::printf("%s/%s\n", folder.c_str(), captions.back().file.c_str());
    std::fflush(stdout);
  }
  save(folder + "/README.md", readme(captions));
  std::printf("%s/README.md\n", folder.c_str());
}

}  // namespace
}  // namespace avo::paper

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "usage: paper_figures FOLDER\n");
    return 2;
  }
  try {
    std::filesystem::create_directories(argv[1]);
    avo::paper::draw_all(argv[1]);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "paper_figures: %s\n", error.what());
    return 4;
  }
  return 0;
}
