// Fetches the packages that sources.tsv names with apt-get and npm, and unpacks each into its own folder.
//
// source.root is that folder: deb and deb-source under their client's name, npm packages under node_modules so that they can import each other.
import {execFileSync} from "node:child_process";
import fs from "node:fs";
import path from "node:path";

export function readSources(file) {
  const rows = fs.readFileSync(file, "utf8").split("\n").filter((line) => line && !line.startsWith("#"));
  return rows.map((line) => {
    const [client, name, version] = line.split("\t");
    return {client, name, version};
  });
}

const quiet = (program, words, cwd) =>
  execFileSync(program, words, {cwd, stdio: ["ignore", "pipe", "pipe"], encoding: "utf8", maxBuffer: 1 << 28});

// Source packages need a deb-src line, which most machines lack: the same suites as the machine's own, in a list of our own.
function sourceOptions(folder) {
  const list = path.join(folder, "apt", "sources.list"), lists = path.join(folder, "apt", "lists");
  const options = ["-o", `Dir::Etc::sourcelist=${list}`, "-o", "Dir::Etc::sourceparts=/dev/null", "-o", `Dir::State::lists=${lists}`,
                   "-o", "APT::Sandbox::User=root"];
  if (fs.existsSync(list)) return options;
  fs.mkdirSync(path.join(lists, "partial"), {recursive: true});
  const targets = quiet("apt-get", ["indextargets", "--format", "$(REPO_URI)|$(RELEASE)|$(COMPONENT)|$(CREATED_BY)"]);
  const lines = targets.split("\n").map((line) => line.split("|")).filter((part) => part[3] === "Packages" && part[1].startsWith("bookworm"));
  const keys = "/usr/share/keyrings/debian-archive-keyring.gpg", signed = fs.existsSync(keys) ? `[signed-by=${keys}] ` : "";
  const text = lines.map(([uri, suite, component]) => `deb-src ${signed}${uri} ${suite} ${component}`);
  fs.writeFileSync(list + ".new", [...new Set(text)].join("\n") + "\n");
  fs.renameSync(list + ".new", list);
  quiet("apt-get", ["update", ...options]);
  return options;
}

function unpack(source, folder, into) {
  const work = path.join(folder, "download", `${source.client}-${source.name.replaceAll("/", "-")}`);
  fs.rmSync(work, {recursive: true, force: true});
  fs.mkdirSync(work, {recursive: true});
  fs.mkdirSync(path.dirname(into), {recursive: true});
  if (source.client === "npm") {
    quiet("npm", ["pack", "--silent", "--ignore-scripts", `${source.name}@${source.version}`], work);
    fs.mkdirSync(into + ".new", {recursive: true});
    quiet("tar", ["-xzf", fs.readdirSync(work)[0], "--strip-components=1", "-C", into + ".new"], work);
  } else if (source.client === "deb") {
    quiet("apt-get", ["download", "-o", "APT::Sandbox::User=root", `${source.name}=${source.version}`], work);
    quiet("dpkg-deb", ["-x", fs.readdirSync(work)[0], into + ".new"], work);
  } else {
    quiet("apt-get", ["source", "--download-only", ...sourceOptions(folder), `${source.name}=${source.version}`], work);
    quiet("dpkg-source", ["--no-check", "--no-copy", "-x", fs.readdirSync(work).find((name) => name.endsWith(".dsc")), into + ".new"], work);
  }
  fs.renameSync(into + ".new", into);
  fs.rmSync(work, {recursive: true, force: true});
}

// Returns the sources with their root, or with why there is none. What is there already is not fetched again.
export function fetchAll(sources, folder) {
  return sources.map((source) => {
    const root = source.client === "npm" ? path.join(folder, "node_modules", source.name) : path.join(folder, source.client, source.name);
    try {
      if (!fs.existsSync(root)) {
        console.error(`fetching ${source.client} ${source.name} ${source.version}`);
        fs.rmSync(root + ".new", {recursive: true, force: true});
        unpack(source, folder, root);
      }
      return {...source, root};
    } catch (error) {
      console.error(`not fetched: ${source.name} ${source.version}: ${String(error.stderr || error.message).trim().split("\n").pop()}`);
      return {...source, root: null};
    }
  });
}
