#include "profiler/scenario/read_sections.h"

#include <algorithm>
#include <bit>
#include <cctype>

#include "profiler/scenario/near_names.h"
#include "profiler/scenario/read_camera.h"
#include "profiler/scenario/read_motion.h"
#include "profiler/scenario/read_passes.h"
#include "profiler/scenario/track_size.h"

namespace reprise {
namespace {

namespace fs = std::filesystem;

std::string readPath(TableReader& reader, const std::string& key, const fs::path& directory, Need need = Need::kRequired) {
  const TomlNode* node = reader.find(key, need);
  std::string text;
  reader.readText(key, text);
  return text.empty() ? text : resolvePath(*node, directory, false, reader.diagnostics());
}

bool isIdentifier(const std::string& name) {
  const auto fits = [](unsigned char letter) { return std::isalnum(letter) || letter == '_'; };
  return !name.empty() && !std::isdigit(static_cast<unsigned char>(name[0])) &&
         std::all_of(name.begin(), name.end(), fits);
}

void readDefines(const TomlNode& node, Scenario& scenario, Diagnostics& diagnostics) {
  TableReader reader(node, "'defines' of [shader]", diagnostics);
  for (const Entry& entry : node.entries) {
    const TomlNode& value = entry.value;
    if (!isIdentifier(entry.key)) {
      diagnostics.add("value",
                      "'" + entry.key + "' cannot be defined, expected a name of letters, digits and '_'",
                      entry.key_place);
    }
    std::string text = value.text;
    if (value.kind == NodeKind::kInteger) {
      text = std::to_string(value.integer);
    } else if (value.kind == NodeKind::kBoolean) {
      text = value.boolean ? "1" : "0";
    } else if (value.kind != NodeKind::kText) {
      // A number with a point has many spellings: the shader is to see the one that the user wrote.
      diagnostics.add("type",
                      "define '" + entry.key + "' is " + describeNode(value) +
                          ", expected a text in quotes, an integer, true or false",
                      value.place);
    }
    scenario.defines.emplace_back(entry.key, text);
  }
}

void readVertexInputs(const TomlNode& node, Scenario& scenario, Diagnostics& diagnostics) {
  TableReader reader(node, "'vertex_inputs' of [shader]", diagnostics);
  for (const Entry& entry : node.entries) {
    if (entry.value.kind != NodeKind::kText)
      diagnostics.add("type", "vertex input '" + entry.key + "' is " + describeNode(entry.value) + ", expected what meshes call it, such as \"position\"",
                      entry.value.place);
    scenario.vertex_inputs.emplace_back(entry.key, entry.value.text);
  }
}

void readPeriods(TableReader& reader, std::vector<std::uint32_t>& periods) {
  const TomlNode* node = reader.find("periods");
  if (!node) return;
  const std::string expected = ", expected 1, 2, 4, ... 64 or \"never\"";
  Diagnostics& diagnostics = reader.diagnostics();
  if (node->kind != NodeKind::kArray || node->elements.empty()) {
    diagnostics.add(
        "type", "'periods' is " + describeNode(*node) + ", expected an array such as [1, 2, 4, \"never\"]",
        node->place);
    return;
  }
  std::vector<std::uint32_t> read;
  for (const TomlNode& element : node->elements) {
    const bool never = element.kind == NodeKind::kText && element.text == "never";
    if (element.kind != NodeKind::kInteger && !never) {
      diagnostics.add(element.kind == NodeKind::kText ? "value" : "type",
                      "a period is " + describeNode(element) + expected, element.place);
      continue;
    }
    const bool fits = never || (element.integer >= 1 && element.integer <= 64 &&
                                std::has_single_bit(static_cast<std::uint64_t>(element.integer)));
    const std::uint32_t period = fits && !never ? static_cast<std::uint32_t>(element.integer) : 0;
    if (!fits) {
      diagnostics.add("value", "a period is " + describeNode(element) + expected, element.place);
    } else if (std::find(read.begin(), read.end(), period) != read.end()) {
      diagnostics.add("value",
                      "the period " + (never ? "\"never\"" : std::to_string(period)) + " is given twice",
                      element.place);
    }
    read.push_back(period);
  }
  periods = read;
}

// The history of a right eye is its left eye, which is computed every second frame: no other period makes sense.
void readStereo(TableReader& reader, Scenario& scenario) {
  const TomlNode* node = reader.find("stereo");
  if (!node) return;
  Stereo stereo;
  TableReader table(*node, "'stereo' of [render]", reader.diagnostics());
  table.readNumber("eye_distance", stereo.eye_distance, kPositive);
  table.finish();
  scenario.stereo = stereo;
  if (!reader.has("periods")) {
    scenario.periods = {1, 2};
    return;
  }
  const std::vector<std::uint32_t>& periods = scenario.periods;
  const bool fits = std::find(periods.begin(), periods.end(), 2u) != periods.end() &&
                    std::all_of(periods.begin(), periods.end(), [](std::uint32_t period) { return period == 1 || period == 2; });
  if (!fits)
    reader.diagnostics().add("value", "the periods of a stereo scenario are 1 and 2, as every second frame is a left eye; expected [1, 2]",
                             reader.find("periods")->place);
}

void readFormats(TableReader& reader, std::vector<std::string>& formats) {
  const TomlNode* node = reader.find("formats");
  if (!node) return;
  Diagnostics& diagnostics = reader.diagnostics();
  if (node->kind != NodeKind::kArray || node->elements.size() > 8) {
    diagnostics.add(
        "type",
        "'formats' is " + describeNode(*node) + ", expected an array of at most 8 formats, one per output",
        node->place);
    return;
  }
  const std::vector<std::string> known(std::begin(kColorFormats), std::end(kColorFormats));
  for (const TomlNode& element : node->elements) {
    const bool is_text = element.kind == NodeKind::kText;
    if (!is_text || std::find(known.begin(), known.end(), element.text) == known.end()) {
      diagnostics.add(is_text ? "value" : "type",
                      "a colour format is " + describeNode(element) + suggestNames(element.text, known),
                      element.place);
    }
    formats.push_back(element.text);
  }
}

UniformBinding readUniform(const std::string& member, const Entry& entry, Diagnostics& diagnostics) {
  UniformBinding binding{member, FixedTrack{{0}}, entry.key_place};
  const TomlNode& value = entry.value;
  if (std::optional<PassSource> source = readPassSource(value, "uniform '" + member + "'", diagnostics)) {
    binding.source = *source;
    return binding;
  }
  if (value.kind != NodeKind::kText) {
    if (std::optional<Track> track = readTrack(value, "uniform '" + member + "'", 0, diagnostics))
      binding.source = *track;
    return binding;
  }
  std::vector<std::string> names;
  for (const auto& named : kSemantics) {
    if (value.text == named.name) {
      binding.source = named.value;
      return binding;
    }
    names.emplace_back(named.name);
  }
  diagnostics.add(
      "value", "uniform '" + member + "' is bound to '" + value.text + "'" + suggestNames(value.text, names),
      value.place);
  return binding;
}

void readDiscs(TableReader& reader, TextureSpec& texture) {
  reader.readInteger("discs_u", texture.discs_u, {1, kMaxDiscs});
  reader.readInteger("discs_v", texture.discs_v, {1, kMaxDiscs});
  reader.readBoolean("object_space", texture.object_space);
  const TomlNode* node = reader.find("objects", Need::kRequired);
  if (!node) return;
  const bool texts = node->kind == NodeKind::kArray && !node->elements.empty() &&
                     std::all_of(node->elements.begin(), node->elements.end(), [](const TomlNode& one) { return one.kind == NodeKind::kText; });
  if (!texts) {
    reader.diagnostics().add("type", "'objects' of texture '" + texture.name + "' is " + describeNode(*node) +
                             ", expected the names of objects, such as [\"knot\"]", node->place);
    return;
  }
  for (const TomlNode& one : node->elements) texture.objects.push_back(one.text);
}

void readSessionMotions(TableReader& reader, const Scenario& scenario, SessionSpec& session) {
  const TomlNode* node = reader.find("motions");
  if (!node) return;
  TableReader motions(*node, "'motions' of session '" + session.name + "'", reader.diagnostics());
  for (const Object& object : scenario.objects) {
    const TomlNode* motion = motions.find(object.name);
    if (!motion) continue;
    session.motions[object.name] =
        readMotion(*motion, "the motion of '" + object.name + "' in session '" + session.name + "'",
                   reader.diagnostics());
  }
  for (const ModelSpec& model : scenario.models)
    if (const TomlNode* motion = motions.find(model.name))
      session.motions[model.name] = readMotion(*motion, "the motion of '" + model.name + "' in session '" + session.name + "'", reader.diagnostics());
  motions.finish();
}

void readSessionUniforms(TableReader& reader, const Scenario& scenario, SessionSpec& session) {
  const TomlNode* node = reader.find("uniforms");
  if (!node) return;
  TableReader uniforms(*node, "'uniforms' of session '" + session.name + "'", reader.diagnostics());
  for (const UniformBinding& binding : scenario.uniforms) {
    const TomlNode* value = uniforms.find(binding.member);
    if (!value) continue;
    const auto* base = std::get_if<Track>(&binding.source);
    const std::string what = "uniform '" + binding.member + "' in session '" + session.name + "'";
    if (std::optional<Track> track =
            readTrack(*value, what, base ? trackSize(*base) : 0, reader.diagnostics())) {
      session.uniforms[binding.member] = *track;
    }
  }
  uniforms.finish();
}

}  // namespace

void readName(TableReader& reader, std::string& name) {
  reader.readText("name", name, Need::kRequired);
  const auto fits = [](unsigned char letter) {
    return std::isalnum(letter) || letter == '_' || letter == '-' || letter == '.';
  };
  if (std::all_of(name.begin(), name.end(), fits) && name != "." && name != "..") return;
  reader.diagnostics().add("value",
                           "the name '" + name + "' of " + reader.what() +
                               " will not do, expected letters, digits, '_', '-' and '.'",
                           reader.find("name")->place);
}

std::string resolvePath(const TomlNode& node, const fs::path& directory, bool is_directory,
                        Diagnostics& diagnostics) {
  const fs::path path = (directory / node.text).lexically_normal();
  std::error_code status;
  if (!fs::exists(path, status)) {
    diagnostics.add(
        "missing_file",
        "there is no " + std::string(is_directory ? "folder" : "file") + " '" + path.string() + "'",
        node.place);
  } else if (fs::is_directory(path, status) != is_directory) {
    diagnostics.add("missing_file",
                    "'" + path.string() + "' is " +
                        (is_directory ? "no folder, expected one" : "a folder, expected a file"),
                    node.place);
  }
  return path.string();
}

void readShader(const TomlNode& node, const fs::path& directory, Scenario& scenario, Diagnostics& diagnostics) {
  TableReader reader(node, "[shader]", diagnostics);
  scenario.fragment_path = readPath(reader, "fragment", directory, Need::kOptional);
  scenario.vertex_path = readPath(reader, "vertex", directory, Need::kOptional);
  reader.readText("fragment_entry_point", scenario.fragment_entry_point);
  reader.readText("vertex_entry_point", scenario.vertex_entry_point);
  if (const TomlNode* folders = reader.find("include_dirs")) {
    if (folders->kind != NodeKind::kArray) {
      diagnostics.add(
          "type",
          "'include_dirs' of [shader] is " + describeNode(*folders) + ", expected an array of folders",
          folders->place);
    }
    for (const TomlNode& folder : folders->elements) {
      if (folder.kind != NodeKind::kText) {
        diagnostics.add("type",
                        "an include folder is " + describeNode(folder) + ", expected a text in quotes",
                        folder.place);
        continue;
      }
      scenario.include_dirs.push_back(resolvePath(folder, directory, true, diagnostics));
    }
  }
  if (const TomlNode* defines = reader.find("defines")) readDefines(*defines, scenario, diagnostics);
  if (const TomlNode* inputs = reader.find("vertex_inputs")) readVertexInputs(*inputs, scenario, diagnostics);
  reader.finish();
}

void readRender(const TomlNode& node, Scenario& scenario, Diagnostics& diagnostics) {
  TableReader reader(node, "[render]", diagnostics);
  reader.readUnsigned("width", scenario.width, {1, kMaxResolution});
  reader.readUnsigned("height", scenario.height, {1, kMaxResolution});
  reader.readInteger("frames", scenario.frames, {1, kMaxFrames});
  reader.readNumber("frame_time_s", scenario.frame_time_s, {0, 10, true});
  readPeriods(reader, scenario.periods);
  readStereo(reader, scenario);
  reader.readUnsigned("seed", scenario.seed);
  reader.readChoice("cull", scenario.state.cull, kCullModes);
  reader.readChoice("depth_compare", scenario.state.compare, kDepthCompares);
  reader.readBoolean("depth_stencil", scenario.state.depth_stencil);
  readFormats(reader, scenario.state.color_formats);
  reader.readNumbers("clear", scenario.state.clear);
  reader.readChoice("tone_map", scenario.tone_map, kToneMaps);
  reader.readNumber("exposure", scenario.exposure, kPositive);
  reader.finish();
}

std::vector<UniformBinding> readUniforms(const TomlNode& node, Diagnostics& diagnostics) {
  std::vector<UniformBinding> bindings;
  TableReader reader(node, "[uniforms]", diagnostics);
  const auto add = [&](const std::string& member, const Entry& entry) {
    if (bindings.size() == kMaxUniforms) {
      diagnostics.add("value", "[uniforms] binds more than " + std::to_string(kMaxUniforms) + " uniforms, expected at most so many",
                      entry.key_place);
      return;
    }
    const bool again = std::any_of(bindings.begin(), bindings.end(),
                                   [&](const auto& known) { return known.member == member; });
    if (again)
      diagnostics.add("value", "uniform '" + member + "' is bound twice, expected once", entry.key_place);
    bindings.push_back(readUniform(member, entry, diagnostics));
  };
  for (const Entry& entry : node.entries) {
    if (entry.key.find('.') != std::string::npos) {
      add(entry.key, entry);
    } else if (entry.value.kind == NodeKind::kTable) {
      for (const Entry& member : entry.value.entries) add(entry.key + "." + member.key, member);
    } else {
      diagnostics.add(
          "value",
          "[uniforms] has '" + entry.key + "', expected \"Block.member\" in quotes or a table of members",
          entry.key_place);
    }
  }
  return bindings;
}

TextureSpec readTexture(const TomlNode& node, const fs::path& directory, Diagnostics& diagnostics) {
  TextureSpec texture;
  TableReader reader(node, "[[texture]]", diagnostics);
  reader.readText("name", texture.name, Need::kRequired);
  texture.place = node.place;
  if (const TomlNode* name = reader.find("name")) texture.place = name->place;
  const std::size_t errors_before = diagnostics.errors.size();
  if (reader.has("file"))
    texture.kind = TextureKind::kFile;
  else if (!reader.has("kind"))
    diagnostics.add("missing_key", "texture '" + texture.name + "' needs 'file' or 'kind'", node.place);
  reader.readChoice("kind", texture.kind, kTextureKinds);
  if (diagnostics.errors.size() != errors_before) return texture;
  if (texture.kind == TextureKind::kFile) {
    texture.path = readPath(reader, "file", directory);
    texture.file_place = reader.find("file")->place;
  } else if (texture.kind == TextureKind::kDiscs) {
    texture.linear = texture.repeat = texture.mipmaps = false;
    readDiscs(reader, texture);
  } else {
    reader.readInteger("size", texture.size, {1, kMaxTextureSize});
    if (hasCells(texture.kind)) reader.readInteger("cells", texture.cells, {1, kMaxTextureSize});
    if (hasSeed(texture.kind)) reader.readUnsigned("seed", texture.seed);
    if (texture.kind == TextureKind::kBumps) {
      reader.readNumber("height", texture.height, kNotNegative);
    } else {
      reader.readNumbers("color_a", texture.color_a, kNotNegative);
      reader.readNumbers("color_b", texture.color_b, kNotNegative);
    }
  }
  reader.readBoolean("linear", texture.linear);
  reader.readBoolean("repeat", texture.repeat);
  reader.readBoolean("mipmaps", texture.mipmaps);
  reader.readBoolean("srgb", texture.srgb);
  reader.finish();
  return texture;
}

SessionSpec readSession(const TomlNode& node, const Scenario& scenario, Diagnostics& diagnostics) {
  SessionSpec session;
  TableReader reader(node, "[[session]]", diagnostics);
  readName(reader, session.name);
  if (!reader.has("role")) reader.find("role", Need::kRequired);
  reader.readChoice("role", session.role, kSessionRoles);
  if (const TomlNode* camera = reader.find("camera", Need::kRequired)) {
    session.camera = readCamera(*camera, "'camera' of session '" + session.name + "'", fs::path(scenario.path).parent_path(), diagnostics);
  }
  if (reader.has("frames"))
    reader.readInteger("frames", session.frames, {1, kMaxFrames});
  else
    reader.find("frames");
  reader.readNumber("speed", session.speed, kNotNegative);
  readSessionMotions(reader, scenario, session);
  readSessionUniforms(reader, scenario, session);
  reader.finish();
  return session;
}

}  // namespace reprise
