"""How deep lie what is under the skin, and what shows of it: eyeballs, teeth, mouth bag."""
