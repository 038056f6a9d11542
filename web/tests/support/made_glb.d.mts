export function madeCharacter(options?: {
  rename?: (name: string) => string | null;
  unit?: number;
  clip?: string;
  picture?: boolean;
}): Buffer;
