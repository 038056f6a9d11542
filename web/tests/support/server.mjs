// Starts and stops `muster studio`.
import { spawn, spawnSync } from 'node:child_process';
import { existsSync, mkdtempSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';

const root = fileURLToPath(new URL('../../..', import.meta.url));

/** The first port that is tried; MUSTER_PORT names another, so that two can test side by side. */
export const kPort = Number(process.env.MUSTER_PORT ?? 18080);

export function programPath() {
  return process.env.MUSTER ?? `${root}build/release/muster`;
}

/** Starts the studio on a free port from `port` on; resolves when it prints its address. Paths from the root; takes are kept in
 * a new folder unless one is named. Without a scenario the studio chooses. `options` are further ones of the studio. */
export async function startStudio({
  scenario = 'web/tests/scenarios/hundred.json',
  port = kPort,
  takes = mkdtempSync(join(tmpdir(), 'muster-takes-')),
  options = [],
} = {}) {
  const shelves = ['--takes', takes, '--places', join(takes, 'places')];
  const first = scenario === '' ? [] : [scenario];
  const server = await startServer(['studio', ...first, '--port', String(port), ...shelves, ...options]);
  return { ...server, scenario, takes };
}

/** Starts `muster study run` or `replay --studio` with these arguments. */
export function startStudy(...args) {
  return startServer(['study', ...args]);
}

/** Runs the program to its end. */
export function runProgram(...args) {
  const { status, stdout, stderr } = spawnSync(programPath(), args, { cwd: root, encoding: 'utf8' });
  return { status, stdout, stderr };
}

async function startServer(args) {
  const program = programPath();
  if (!existsSync(program)) throw new Error(`There is no ${program}: build it first, or name another by MUSTER=...`);
  const child = spawn(program, args, { cwd: root, stdio: ['ignore', 'pipe', 'pipe'] });
  let output = '';
  const url = await new Promise((resolve, reject) => {
    const timer = setTimeout(() => reject(new Error(`The server said no address in 20 s:\n${output}`)), 20000);
    const hear = (data) => {
      output += data;
      const found = /http:\/\/[^\s/]+\//.exec(output);
      if (!found) return;
      clearTimeout(timer);
      resolve(found[0]);
    };
    child.stdout.on('data', hear);
    child.stderr.on('data', hear);
    child.once('exit', (code) => reject(new Error(`The server ended with code ${code}:\n${output}`)));
  });
  const stop = () =>
    new Promise((resolve) => {
      if (child.exitCode !== null || child.signalCode !== null) return resolve();
      child.once('exit', resolve);
      child.kill('SIGINT');
      setTimeout(() => child.kill('SIGKILL'), 3000).unref();
    });
  return {
    url,
    port: Number(new URL(url).port),
    stop,
    kill: () => child.kill('SIGKILL'),
    output: () => output,
  };
}
