// Chromium as all tests and films start it.
import { chromium } from 'playwright-core';

const kFlags = ['--no-sandbox', '--use-gl=angle', '--use-angle=gl-egl', '--ignore-gpu-blocklist'];

/** CHROMIUM names another one than Debian's. */
export const openChromium = () =>
  chromium.launch({ executablePath: process.env.CHROMIUM ?? '/usr/bin/chromium', args: kFlags });
