// A studio that other machines may enter (--lan): without its token they get nothing. Here 127.0.0.2 plays the network's
// address: it is this machine, but not the desk.
import http from 'node:http';
import { randomBytes } from 'node:crypto';
import { kSubprotocol } from './client.mjs';

const kNetwork = '127.0.0.2';

/** A request to an address; resolves with status, headers and body. A WebSocket that opens has status 101. */
function ask(address, port, path, headers = {}, method = 'GET') {
  return new Promise((resolve, reject) => {
    const asked = http.request({ host: address, port, path, method, headers: { Host: `${address}:${port}`, ...headers } });
    asked.on('response', (answer) => {
      let body = '';
      answer.on('data', (chunk) => (body += chunk));
      answer.on('end', () => resolve({ status: answer.statusCode, headers: answer.headers, body }));
    });
    asked.on('upgrade', (answer, socket) => {
      socket.destroy();
      resolve({ status: answer.statusCode, headers: answer.headers, body: '' });
    });
    asked.on('error', reject);
    asked.end();
  });
}

function upgrade(port, headers) {
  return {
    Connection: 'Upgrade',
    Upgrade: 'websocket',
    Origin: `http://${kNetwork}:${port}`,
    'Sec-WebSocket-Key': randomBytes(16).toString('base64'),
    'Sec-WebSocket-Version': '13',
    'Sec-WebSocket-Protocol': kSubprotocol,
    ...headers,
  };
}

/** `begin` starts a studio with options and resolves with what it printed as JSON, and a way to end it. */
export async function lanTests({ test, check, begin, closed }) {
  await test('without --lan nobody listens on another address', async () => {
    let error = null;
    await ask(kNetwork, closed, '/').catch((e) => (error = e));
    check(error?.code === 'ECONNREFUSED', `another address: ${error?.code}`);
  });
  const studio = await begin('--lan', '--json');
  const { port, token } = studio.said;
  const cookie = { Cookie: `muster-${port}=${token}` };

  await test('the token is new each time, and of 128 bits', async () => {
    check(/^[0-9a-f]{32}$/.test(token), `token: ${token}`);
    for (const link of studio.said.links) check(link.endsWith(`:${port}/?token=${token}`), `link: ${link}`);
  });

  await test('without the token there is nothing', async () => {
    for (const path of ['/', '/assets/app-1.js', '/health', '/take', '/invitation.json', '/?token=', `/?token=${token.slice(1)}`]) {
      const answer = await ask(kNetwork, port, path);
      check(answer.status === 403, `${path}: ${answer.status}`);
      check(!answer.headers['set-cookie'], `${path}: a cookie`);
      check(!answer.body.includes(token), `${path}: tells the token`);
    }
    check((await ask(kNetwork, port, '/ws', upgrade(port, {}))).status === 403, 'WebSocket');
    check((await ask(kNetwork, port, '/take', { Origin: `http://${kNetwork}:${port}` }, 'POST')).status === 403, 'POST');
    const other = { Cookie: `muster-${port}=${'0'.repeat(32)}` };
    check((await ask(kNetwork, port, '/', other)).status === 403, 'another token');
  });

  await test('the link gives a cookie, and the cookie opens everything', async () => {
    const answer = await ask(kNetwork, port, `/?token=${token}`);
    check(answer.status === 303 && answer.headers.location === '/', `link: ${answer.status}`);
    const [given] = answer.headers['set-cookie'];
    check(given.startsWith(`muster-${port}=${token};`), `cookie: ${given}`);
    check(/HttpOnly/.test(given) && /SameSite=Lax/.test(given), `cookie: ${given}`);
    check((await ask(kNetwork, port, '/', cookie)).status === 200, 'page');
    check((await ask(kNetwork, port, '/take', cookie)).status === 200, 'take');
    check((await ask(kNetwork, port, '/ws', upgrade(port, cookie))).status === 101, 'WebSocket');
    const policy = (await ask(kNetwork, port, '/', cookie)).headers['content-security-policy'];
    check(policy.includes(`ws://${kNetwork}:${port}`) && !policy.includes('localhost'), policy);
  });

  await test('a token does not open the door to other sites', async () => {
    for (const Host of ['evil.example', `evil.example:${port}`, `127.0.0.1:${port}`, kNetwork])
      check((await ask(kNetwork, port, '/', { ...cookie, Host })).status === 403, `Host ${Host}`);
    for (const Origin of ['http://evil.example', `http://127.0.0.1:${port}`, 'null'])
      check((await ask(kNetwork, port, '/ws', upgrade(port, { ...cookie, Origin }))).status === 403, `Origin ${Origin}`);
  });

  await test('the desk needs no token, and reads the invitation', async () => {
    check((await ask('127.0.0.1', port, '/')).status === 200, 'page');
    const answer = await ask('127.0.0.1', port, '/invitation.json');
    const { links, code } = JSON.parse(answer.body);
    check(JSON.stringify(links) === JSON.stringify(studio.said.links), `links: ${answer.body}`);
    check((links.length > 0) === code.length > 0, 'code');
    check(answer.headers['cache-control'] === 'no-store', 'kept');
  });
  await studio.end();
}
